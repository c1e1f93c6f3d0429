package starlogo.queries.motion
{
    import flash.geom.Vector3D;
    import starlogo.convex.ContactPoint;
    import starlogo.data.IntList;
    import starlogo.engine;
    import starlogo.search.ModelShape;

    use namespace engine;

    /**
     * Gets a body out of what it overlaps. It frees the shrunk body where a motion begins (depenetrate), leads the body off what it touches where its
     * motions end (restoreClearance), and tells a walk how deep the body is in others (measureOverlaps).
     *
     * <p>A shallow overlap comes from rounding in the game: the body is pushed out of it. If the body overlaps a row more deeply, the plane of their
     * contact stands for that row. The motion must not cross the plane, and nothing else of the row counts. If no pushes lead out of shallow overlaps, planes
     * stand for these rows too.</p>
     *
     * <p>A push is a contact whose depth says how far it leads: a clearance farther than out of the overlap. The pushes go from one row after the other,
     * in rounds, because a push out of one side of a hollow leads a part of the way into another. If the body does not get free, for example between two
     * opposite walls, it stays where it was. The tests of a pair know the shortest way out of that pair (PairTests.separate).</p>
     *
     * @private
     */
    public final class Depenetration
    {
        private static const NO_MOTION:Vector3D = new Vector3D();

        private static const MAX_ROUNDS:int = 30;

        // From this round on contacts have to separate. Contacts of parts of a body may point sideways, round after round.
        private static const FIRST_SEPARATING_ROUND:int = 2;

        // If a body only touches a row, it is never this many slops deep in it.
        private static const SLOPS_OF_TOUCH:Number = 2;

        // Two normals are opposite if the cosine of the angle between them is less than this.
        private static const OPPOSITE:Number = -0.999;

        /** The shrunk body that is freed, with the tolerances of its motion. Others may use it between two calls. Read only. */
        public var shrunk:ShrunkBody = new ShrunkBody();

        // Where the pushes have led, and the last one. Its normal is 0 before the first.
        private var _pushedPlace:Vector3D = new Vector3D();
        private var _lastPush:ContactPoint = new ContactPoint();

        // Pushes off touches, which no motion takes back.
        private var _uncounted:ContactList = new ContactList();

        // A contact, a place, and the way from there to the body, within one call.
        private var _contact:ContactPoint = new ContactPoint();
        private var _touchingPlace:Vector3D = new Vector3D();
        private var _beside:Vector3D = new Vector3D();

        /**
         * Frees the shrunk body from the obstacles that it overlaps where its motion starts. The motion has begun it.
         *
         * @param start where the motion starts, which changes if the body is pushed
         * @param obstacles the rows that can stop the motion. A row with a plane leaves them
         * @param planes receives the contacts of the overlaps that stay
         * @param pushes receives the contacts of the pushes
         */
        public function depenetrate(start:Vector3D, obstacles:IntList, planes:ContactList, pushes:ContactList):void
        {
            if (replaceByPlanes(start, obstacles, planes, false) && !pushAway(obstacles, false, start, pushes))
            {
                replaceByPlanes(start, obstacles, planes, true);
            }
            if (shrunk.isFlat && planes.count == 0)
            {
                // the shrunk body is as flat, and a sweep touches across a wider gap than a body that stands
                pushAway(obstacles, true, start, _uncounted);
            }
        }

        /**
         * Leads a body that stands a clearance off its rows that it touches, if there is room, and a flat body also off rows that it is close to. Rows
         * that it overlaps deeply do not count, nor one-way rows that it passes.
         *
         * @param place the place of the body, which changes
         */
        public function restoreClearance(body:MovingBody, place:Vector3D):void
        {
            shrunk.begin(body, body.rows, place, NO_MOTION);
            pushAway(body.rows, true, place, _uncounted);
        }

        /**
         * Finds how deep a body overlaps its rows at a place. Overlaps that are shallow do not count, nor those with one-way rows, nor those with a tree out
         * of which the way is too long.
         *
         * @param deepest receives the push out of the deepest overlap, with the depth 0 if there is none
         * @return the sum of the depths of all these pushes
         */
        public function measureOverlaps(body:MovingBody, place:Vector3D, deepest:ContactPoint):Number
        {
            var sum:Number = 0;
            deepest.depth = 0;
            shrunk.begin(body, body.rows, place, NO_MOTION);
            for (var i:int = 0; i < body.rows.count; i++)
            {
                var row:int = body.rows.values[i];
                if (!body.isOneWay(row) && shrunk.touches(row, place) && findPushOutOfDeep(row, place, _contact))
                {
                    sum += _contact.depth;
                    if (_contact.depth > deepest.depth)
                    {
                        deepest.copyFrom(_contact);
                    }
                }
            }
            return sum;
        }

        // Finds a push out of a row that the shrunk body touches at a place. Returns whether the overlap is deep, and the push is not too long.
        private function findPushOutOfDeep(row:int, place:Vector3D, out:ContactPoint):Boolean
        {
            var body:MovingBody = shrunk.body;
            body.findContact(row, place, true, out);
            if (body.isShallow(row, out) || !shrunk.fullBodyOverlaps(row, place))
            {
                return false;
            }
            warnOfInside(body, row, out);
            out.depth += shrunk.clearance;
            // the shortest way out of a tree may lead through a wall of the tree if it is longer than the way to the middle of the body
            return body.bodyOf(row).kind != ModelShape.TREE || out.depth <= body.fullBody.halfAlong(out);
        }

        // Pushes the body, in rounds: out of rows that the shrunk body overlaps, or a clearance off rows that the body touches. Returns whether it gets free.
        // If an overlap is too deep for a push, or if the body is between two rows, it stays where it is, and there are no pushes.
        private function pushAway(rows:IntList, offTouches:Boolean, place:Vector3D, pushes:ContactList):Boolean
        {
            var push:ContactPoint = _contact;
            var isFree:Boolean = false;
            _pushedPlace.copyFrom(place);
            _lastPush.setNormal(0, 0, 0);
            pushes.clear();
            for (var round:int = 0; !isFree; round++)
            {
                isFree = true;
                for (var i:int = 0; i < rows.count; i++)
                {
                    var row:int = rows.values[i];
                    if (offTouches ? findPushOff(row, round, push) : findPushOut(row, round, push))
                    {
                        if (!tryPush(push, round))
                        {
                            pushes.clear();
                            return false;
                        }
                        pushes.add(push, row);
                        isFree = false;
                    }
                }
            }
            place.copyFrom(_pushedPlace);
            return true;
        }

        // Pushes the body. Returns whether it does: not if the push is infinite, if the body is between two rows, or after too many rounds.
        private function tryPush(push:ContactPoint, round:int):Boolean
        {
            // a flat body may be led back in the first round: of the two ways out of a sheet, one may lead into the next row
            var isBetween:Boolean = leadsBack(push) && !(shrunk.isFlat && round == 0);
            if (isBetween || round == MAX_ROUNDS || push.depth == Infinity)
            {
                return false;
            }
            push.movePoint(_pushedPlace, push.depth);
            _lastPush.copyFrom(push);
            return true;
        }

        // Lets planes stand for obstacles that the shrunk body overlaps: for deep overlaps, and also for shallow ones if they are to count. These are
        // obstacles no longer, nor are one-way rows that the body passes. Returns whether obstacles are left that the shrunk body overlapped.
        private function replaceByPlanes(start:Vector3D, obstacles:IntList, planes:ContactList, alsoShallow:Boolean):Boolean
        {
            var isLeft:Boolean = false;
            var i:int = 0;
            while (i < obstacles.count)
            {
                var row:int = obstacles.values[i];
                var isOverlapped:Boolean = shrunk.touches(row, start);
                if (isOverlapped && (shrunk.body.passesOneWayAt(row, start) || tryReplaceByPlane(row, start, planes, alsoShallow)))
                {
                    obstacles.remove(row);
                }
                else
                {
                    isLeft ||= isOverlapped;
                    i++;
                }
            }
            return isLeft;
        }

        // Lets a plane stand for a row that the shrunk body overlaps, if the overlap counts and a plane is needed. First the shrunk body gets
        // smaller, for the whole motion. If it is free of the row then, no plane is needed. None is needed either if only the shrunk body overlaps
        // the row, not the body. Returns whether the plane stands.
        private function tryReplaceByPlane(row:int, start:Vector3D, planes:ContactList, alsoShallow:Boolean):Boolean
        {
            var body:MovingBody = shrunk.body;
            body.findContact(row, start, alsoShallow, _contact);
            if (!alsoShallow && body.isShallow(row, _contact))
            {
                return false;
            }
            if (shrunk.shrinkUntilFree(row, start) || !shrunk.fullBodyOverlaps(row, start))
            {
                return false;
            }
            planes.add(_contact, row);
            warnOfInside(body, row, _contact);
            return true;
        }

        // Finds a push out of a row that the shrunk body overlaps. It is infinite if the overlap is deep. Returns whether there is an overlap.
        private function findPushOut(row:int, round:int, out:ContactPoint):Boolean
        {
            if (!shrunk.touches(row, _pushedPlace))
            {
                return false;
            }
            findContactOfPush(row, _pushedPlace, round, out);
            if (!shrunk.body.isShallow(row, out))
            {
                out.depth = Infinity;
            }
            out.depth += shrunk.clearance;
            return true;
        }

        // Finds a push off a row. Returns whether there is one: not if the body does not touch the row, overlaps it deeply or passes it.
        private function findPushOff(row:int, round:int, out:ContactPoint):Boolean
        {
            var body:MovingBody = shrunk.body;
            var place:Vector3D = _touchingPlace;
            // mostly it is known faster that the shrunk body touches the row than how deep the overlap is
            if (!findTouchingPlace(row, place) || body.passesOneWayAt(row, place) || (!shrunk.isFlat && shrunk.touches(row, _pushedPlace)))
            {
                return false;
            }
            findContactOfPush(row, place, round, out);
            var most:Number = SLOPS_OF_TOUCH * shrunk.slop;
            if (out.depth > most && !body.isShallow(row, out))
            {
                return false;
            }
            _beside.copyFrom(_pushedPlace);
            _beside.decrementBy(place);
            // how far the body is along the normal already
            var ahead:Number = out.along(_beside);
            if (ahead < 0)
            {
                // the body is so thin that the shortest way out there leads to the other side of the row: it goes on from the row along the axis
                out.setNormal(_beside.x, _beside.y, _beside.z);
                out.normalise();
                out.depth = shrunk.clearance;
            }
            else
            {
                out.depth = Math.min(out.depth, most) - ahead + shrunk.clearance;
            }
            return out.depth > 0;
        }

        // Finds the contact for a push away from a row that the body touches at a place. From a few rounds on it separates the two. Before, it need not if that
        // leads on from the last push. The contact of a flat body with a part that is as flat may point to either side, so it separates, if that is a short way.
        private function findContactOfPush(row:int, place:Vector3D, round:int, out:ContactPoint):void
        {
            var body:MovingBody = shrunk.body;
            var mustSeparate:Boolean = round >= FIRST_SEPARATING_ROUND;
            body.findContact(row, place, mustSeparate || shrunk.isFlat, out);
            if (!mustSeparate && !shrunk.isFlat && leadsBack(out))
            {
                body.findContact(row, place, true, out);
            }
            else if (!mustSeparate && shrunk.isFlat && !body.isShallow(row, out))
            {
                // exactly in the planes of a row, the way out of all its parts may be long
                body.findContact(row, place, false, out);
            }
        }

        // Whether a push leads back against the last one. Then the body is between two rows.
        private function leadsBack(push:ContactPoint):Boolean
        {
            return push.normalX * _lastPush.normalX + push.normalY * _lastPush.normalY + push.normalZ * _lastPush.normalZ < OPPOSITE;
        }

        // Finds where the body touches a row: where the pushes have led, or if the body is flat, half of a clearance beside this along an axis. Returns whether
        // it touches the row at one of these.
        private function findTouchingPlace(row:int, out:Vector3D):Boolean
        {
            out.copyFrom(_pushedPlace);
            var touches:Boolean = shrunk.fullBodyTouches(row, out);
            for (var i:int = 0; shrunk.isFlat && !touches && i < 6; i++)
            {
                var beside:Number = i < 3 ? -shrunk.clearance / 2 : shrunk.clearance / 2;
                var x:Number = i % 3 == 2 ? beside : 0;
                var y:Number = i % 3 == 1 ? beside : 0;
                var z:Number = i % 3 == 0 ? beside : 0;
                out.setTo(_pushedPlace.x + x, _pushedPlace.y + y, _pushedPlace.z + z);
                touches = shrunk.fullBodyTouches(row, out);
            }
            return touches;
        }
    }
}
