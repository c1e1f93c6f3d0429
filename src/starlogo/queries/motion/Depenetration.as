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
     * <p>Each push is a clearance longer than the depth of its contact. The pushes go from one row after the other, in rounds, because a push out of
     * one side of a hollow leads a part of the way into another. If it does not get free, for example between two opposite walls, it stays where it
     * was. The tests of a pair know the shortest way out of that pair (PairTests.separate).</p>
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

        // The contact of an overlap, or of the next push.
        private var _contact:ContactPoint = new ContactPoint();

        // Where the pushes have led, and the contact of the last one. Its normal is 0 before the first.
        private var _pushedPlace:Vector3D = new Vector3D();
        private var _lastPush:ContactPoint = new ContactPoint();

        // Where the body touches a row, for a push off that row.
        private var _touchingPlace:Vector3D = new Vector3D();

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
            if (replaceByPlanes(start, obstacles, planes, false) && !pushOutOfShallow(start, obstacles, pushes))
            {
                replaceByPlanes(start, obstacles, planes, true);
            }
            if (shrunk.isFlat && planes.count == 0)
            {
                // the shrunk body is as flat, and a sweep touches across a wider gap than a body that stands
                pushOffTouches(obstacles, start);
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
            pushOffTouches(body.rows, place);
        }

        /**
         * Finds how deep a body overlaps its rows at a place. Overlaps that are shallow do not count, nor those with one-way rows, nor those with a tree out
         * of which the way is too long.
         *
         * @param deepest receives the contact of the deepest overlap, with the depth 0 if there is none. A push along its normal by its depth leads a
         *     clearance out
         * @return the sum of the depths of all overlaps
         */
        public function measureOverlaps(body:MovingBody, place:Vector3D, deepest:ContactPoint):Number
        {
            var sum:Number = 0;
            deepest.depth = 0;
            shrunk.begin(body, body.rows, place, NO_MOTION);
            for (var i:int = 0; i < body.rows.count; i++)
            {
                var row:int = body.rows.values[i];
                if (!body.isOneWay(row) && shrunk.touches(row, place) && findDeepOverlap(row, place))
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

        // Finds the contact for a push out of a row that the shrunk body touches at a place. Returns whether the overlap is deep, and the push is not too long.
        private function findDeepOverlap(row:int, place:Vector3D):Boolean
        {
            var body:MovingBody = shrunk.body;
            body.findSeparatingContact(row, place, _contact);
            if (body.isShallow(row, _contact) || !shrunk.fullBodyOverlaps(row, place))
            {
                return false;
            }
            body.warnIfInside(row, _contact);
            _contact.depth += shrunk.clearance;
            // the shortest way out of a tree may lead through a wall of the tree if it is longer than the way to the middle of the body
            return body.bodyOf(row).kind != ModelShape.TREE || _contact.depth <= body.fullBody.halfAlong(_contact);
        }

        // Pushes the body out of the obstacles that the shrunk body overlaps. Returns whether it gets free. If an overlap is deep, or if the body is between two
        // rows, it stays where it is, and there are no pushes.
        private function pushOutOfShallow(start:Vector3D, obstacles:IntList, pushes:ContactList):Boolean
        {
            beginPushes(start);
            var isFree:Boolean = false;
            for (var round:int = 0; !isFree; round++)
            {
                isFree = true;
                for (var i:int = 0; i < obstacles.count; i++)
                {
                    var row:int = obstacles.values[i];
                    if (shrunk.touches(row, _pushedPlace))
                    {
                        findContactOfPush(row, _pushedPlace, round);
                        if (!shrunk.body.isShallow(row, _contact) || !tryPush(_contact.depth + shrunk.clearance, round))
                        {
                            pushes.clear();
                            return false;
                        }
                        pushes.add(_contact, row);
                        isFree = false;
                    }
                }
            }
            start.copyFrom(_pushedPlace);
            return true;
        }

        // Pushes the body a clearance off the rows that it touches. If it is between two of them, it stays where it is.
        private function pushOffTouches(rows:IntList, place:Vector3D):void
        {
            beginPushes(place);
            var isFree:Boolean = false;
            for (var round:int = 0; !isFree; round++)
            {
                isFree = true;
                for (var i:int = 0; i < rows.count; i++)
                {
                    var length:Number = findPushOff(rows.values[i], round);
                    if (length > 0)
                    {
                        if (!tryPush(length, round))
                        {
                            return;
                        }
                        isFree = false;
                    }
                }
            }
            place.copyFrom(_pushedPlace);
        }

        private function beginPushes(place:Vector3D):void
        {
            _pushedPlace.copyFrom(place);
            _lastPush.setNormal(0, 0, 0);
        }

        // Pushes the body along the contact. Returns whether it does: not if the body is between two rows, or after too many rounds.
        private function tryPush(length:Number, round:int):Boolean
        {
            // a flat body may be led back in the first round: of the two ways out of a sheet, one may lead into the next row
            var isBetween:Boolean = leadsBack() && !(shrunk.isFlat && round == 0);
            if (isBetween || round == MAX_ROUNDS)
            {
                return false;
            }
            _contact.movePoint(_pushedPlace, length);
            _lastPush.copyFrom(_contact);
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
                if (isOverlapped && (shrunk.body.passesOneWayAt(row, start, _contact) || tryReplaceByPlane(row, start, planes, alsoShallow)))
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
            body.findContact(row, start, _contact);
            if (body.isShallow(row, _contact))
            {
                if (!alsoShallow)
                {
                    return false;
                }
                body.findSeparatingContact(row, start, _contact);
            }
            if (shrunk.shrinkUntilFree(row, start) || !shrunk.fullBodyOverlaps(row, start))
            {
                return false;
            }
            planes.add(_contact, row);
            body.warnIfInside(row, _contact);
            return true;
        }

        // Finds the contact for a push off a row. Returns the length of the push: 0 if the body does not touch the row, overlaps it deeply or passes it.
        private function findPushOff(row:int, round:int):Number
        {
            var body:MovingBody = shrunk.body;
            // mostly it is known faster that the shrunk body touches the row than how deep the overlap is
            if (!findTouchingPlace(row) || body.passesOneWayAt(row, _touchingPlace, _contact) || (!shrunk.isFlat && shrunk.touches(row, _pushedPlace)))
            {
                return 0;
            }
            findContactOfPush(row, _touchingPlace, round);
            var most:Number = SLOPS_OF_TOUCH * shrunk.slop;
            if (_contact.depth > most && !body.isShallow(row, _contact))
            {
                return 0;
            }
            var toX:Number = _pushedPlace.x - _touchingPlace.x;
            var toY:Number = _pushedPlace.y - _touchingPlace.y;
            var toZ:Number = _pushedPlace.z - _touchingPlace.z;
            // how far the body is along the normal already
            var ahead:Number = _contact.normalX * toX + _contact.normalY * toY + _contact.normalZ * toZ;
            if (ahead < 0)
            {
                // the body is so thin that the shortest way out there leads to the other side of the row: it goes on from the row along the axis
                _contact.setNormal(toX, toY, toZ);
                _contact.normalise();
                return shrunk.clearance;
            }
            return Math.min(_contact.depth, most) - ahead + shrunk.clearance;
        }

        // Finds the contact for a push away from a row that the body touches at a place. From a few rounds on it separates the two. Before, it need not if that
        // leads on from the last push. The contact of a flat body with a part that is as flat may point to either side, so it separates, if that is a short way.
        private function findContactOfPush(row:int, place:Vector3D, round:int):void
        {
            var body:MovingBody = shrunk.body;
            var mustSeparate:Boolean = round >= FIRST_SEPARATING_ROUND;
            if (!mustSeparate && !shrunk.isFlat)
            {
                body.findContact(row, place, _contact);
                if (!leadsBack())
                {
                    return;
                }
            }
            body.findSeparatingContact(row, place, _contact);
            if (!mustSeparate && shrunk.isFlat && !body.isShallow(row, _contact))
            {
                // exactly in the planes of a row, the way out of all its parts may be long
                body.findContact(row, place, _contact);
            }
        }

        // Whether a push along the contact leads back against the last one. Then the body is between two rows.
        private function leadsBack():Boolean
        {
            return _contact.normalX * _lastPush.normalX + _contact.normalY * _lastPush.normalY + _contact.normalZ * _lastPush.normalZ < OPPOSITE;
        }

        // Finds where the body touches a row: where the pushes have led, or if the body is flat, half of a clearance beside this along an axis. Returns whether
        // it touches the row at one of these.
        private function findTouchingPlace(row:int):Boolean
        {
            _touchingPlace.copyFrom(_pushedPlace);
            var touches:Boolean = shrunk.fullBodyTouches(row, _touchingPlace);
            for (var i:int = 0; shrunk.isFlat && !touches && i < 6; i++)
            {
                var beside:Number = i < 3 ? -shrunk.clearance / 2 : shrunk.clearance / 2;
                var x:Number = i % 3 == 2 ? beside : 0;
                var y:Number = i % 3 == 1 ? beside : 0;
                var z:Number = i % 3 == 0 ? beside : 0;
                _touchingPlace.setTo(_pushedPlace.x + x, _pushedPlace.y + y, _pushedPlace.z + z);
                touches = shrunk.fullBodyTouches(row, _touchingPlace);
            }
            return touches;
        }
    }
}
