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

        // The shrunk body that stands, with its tolerances.
        private var _shrunk:ShrunkBody = new ShrunkBody();

        // The pushes off what the body touches.
        private var _pushesOff:ContactList = new ContactList();

        // The contact of an overlap, or of this push.
        private var _contact:ContactPoint = new ContactPoint();

        // A place that is tried: where the body touches a row.
        private var _tried:Vector3D = new Vector3D();

        /**
         * Frees the shrunk body from the obstacles that it overlaps where its motion starts.
         *
         * @param sweep the motion. It receives the planes of overlaps that stay. A row with a plane leaves its obstacles. Its start changes if the body is
         *     pushed
         */
        public function depenetrate(sweep:ShrunkSweep):void
        {
            if (replaceByPlanes(sweep, false) && !pushOutOfShallow(sweep))
            {
                replaceByPlanes(sweep, true);
            }
            if (sweep.shrunk.isFlat && sweep.planes.count == 0)
            {
                // the shrunk body is as flat, and a sweep touches across a wider gap than a body that stands
                pushOffTouches(sweep.shrunk, sweep.obstacles, sweep.start);
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
            _shrunk.begin(body, body.rows, place, NO_MOTION);
            pushOffTouches(_shrunk, body.rows, place);
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
            _shrunk.begin(body, body.rows, place, NO_MOTION);
            for (var i:int = 0; i < body.rows.count; i++)
            {
                var row:int = body.rows.values[i];
                if (body.isOneWay(row) || !_shrunk.shrunkTouches(row, place))
                {
                    continue;
                }
                body.findContact(row, place, true, _contact);
                if (body.isShallow(row, _contact) || !_shrunk.bodyOverlaps(row, place))
                {
                    continue;
                }
                body.warnIfInside(row, _contact);
                _contact.depth += _shrunk.clearance;
                // the shortest way out of a tree may lead through a wall of the tree if it is longer than the way to the middle of the body
                if (body.bodyOf(row).kind != ModelShape.TREE || _contact.depth <= body.fullBody.halfAlong(_contact))
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

        // Pushes a body out of the obstacles that the shrunk body overlaps. Returns whether it is free then.
        private function pushOutOfShallow(sweep:ShrunkSweep):Boolean
        {
            return pushInRounds(sweep.shrunk, sweep.obstacles, sweep.start, false, sweep.pushes);
        }

        // Pushes a body a clearance off the rows that it touches, if it gets free.
        private function pushOffTouches(shrunk:ShrunkBody, rows:IntList, place:Vector3D):void
        {
            pushInRounds(shrunk, rows, place, true, _pushesOff);
        }

        // Pushes a body away from one row after the other, in rounds, until a round needs no push. Returns whether it is free then. If not, it is where it was,
        // and there are no pushes. Its callers say what it is pushed away from.
        private function pushInRounds(shrunk:ShrunkBody, rows:IntList, place:Vector3D, offTouches:Boolean, pushes:ContactList):Boolean
        {
            var last:ContactPoint = null;
            var isFree:Boolean = false;
            var x:Number = place.x;
            var y:Number = place.y;
            var z:Number = place.z;
            pushes.clear();
            for (var round:int = 0; !isFree; round++)
            {
                isFree = true;
                for (var i:int = 0; i < rows.count; i++)
                {
                    var row:int = rows.values[i];
                    var length:Number = offTouches ? findPushOff(shrunk, row, place, round, last) : findPushOut(shrunk, row, place, round, last);
                    if (!(length > 0))
                    {
                        continue;
                    }
                    // a flat body may be led back in the first round: of the two ways out of a sheet, one may lead into the next row
                    var isBetween:Boolean = leadsBack(_contact, last) && !(shrunk.isFlat && round == 0);
                    if (length == Infinity || round == MAX_ROUNDS || isBetween)
                    {
                        place.setTo(x, y, z);
                        pushes.clear();
                        return false;
                    }
                    _contact.movePoint(place, length);
                    last = pushes.contacts[pushes.add(_contact, row)];
                    isFree = false;
                }
            }
            return true;
        }

        // Finds the contact for a push out of a row. Returns the length of the push: 0 if the shrunk body does not touch the row, Infinity if the overlap is not
        // shallow.
        private function findPushOut(shrunk:ShrunkBody, row:int, place:Vector3D, round:int, last:ContactPoint):Number
        {
            if (!shrunk.shrunkTouches(row, place))
            {
                return 0;
            }
            findContactOfPush(shrunk, row, place, round, last);
            return shrunk.body.isShallow(row, _contact) ? _contact.depth + shrunk.clearance : Infinity;
        }

        // Lets planes stand for obstacles that the shrunk body overlaps: for deep overlaps, and also for shallow ones if they are to count. These are
        // obstacles no longer, nor are one-way rows that the body passes. Returns whether obstacles are left that the shrunk body overlapped.
        private function replaceByPlanes(sweep:ShrunkSweep, alsoShallow:Boolean):Boolean
        {
            var obstacles:IntList = sweep.obstacles;
            var isLeft:Boolean = false;
            var i:int = 0;
            while (i < obstacles.count)
            {
                var row:int = obstacles.values[i];
                var isOverlapped:Boolean = sweep.shrunk.shrunkTouches(row, sweep.start);
                if (isOverlapped && (sweep.shrunk.body.passesOneWayAt(row, sweep.start, _contact) || addPlane(row, sweep, alsoShallow)))
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

        // Lets a plane stand for a row that the shrunk body overlaps, if the overlap counts and a plane is needed. First the shrunk body becomes
        // narrower, for the whole motion. If it is free of the row then, no plane is needed. None is needed either if only the shrunk body overlaps
        // the row, not the body. Returns whether the plane stands.
        private function addPlane(row:int, sweep:ShrunkSweep, alsoShallow:Boolean):Boolean
        {
            var shrunk:ShrunkBody = sweep.shrunk;
            shrunk.body.findContact(row, sweep.start, alsoShallow, _contact);
            var isCounted:Boolean = alsoShallow || !shrunk.body.isShallow(row, _contact);
            if (!isCounted || shrunk.tryNarrow(row, sweep.start) || !shrunk.bodyOverlaps(row, sweep.start))
            {
                return false;
            }
            sweep.planes.add(_contact, row);
            shrunk.body.warnIfInside(row, _contact);
            return true;
        }

        // Finds the contact for a push off a row. Returns the length of the push: 0 if the body does not touch the row, overlaps it deeply or passes it.
        private function findPushOff(shrunk:ShrunkBody, row:int, place:Vector3D, round:int, last:ContactPoint):Number
        {
            var body:MovingBody = shrunk.body;
            // mostly it is known faster that the shrunk body touches the row than how deep the overlap is
            if (!findTouchingPlace(shrunk, row, place, _tried) || body.passesOneWayAt(row, _tried, _contact)
                    || (!shrunk.isFlat && shrunk.shrunkTouches(row, place)))
            {
                return 0;
            }
            findContactOfPush(shrunk, row, _tried, round, last);
            var most:Number = SLOPS_OF_TOUCH * shrunk.slop;
            if (_contact.depth > most && !body.isShallow(row, _contact))
            {
                return 0;
            }
            // how far the body's own place, at which a flat body does not touch the row, is along the normal
            var shift:Number = _contact.normalX * (place.x - _tried.x) + _contact.normalY * (place.y - _tried.y) + _contact.normalZ * (place.z - _tried.z);
            if (shift < 0)
            {
                // the body is so thin that the shortest way out there leads to the other side of the row: it goes on from the row along the axis
                _contact.setNormal(place.x - _tried.x, place.y - _tried.y, place.z - _tried.z);
                _contact.normalise();
                return shrunk.clearance;
            }
            return Math.min(_contact.depth, most) - shift + shrunk.clearance;
        }

        // Finds the contact with a row that the body touches at a place. In the first rounds the other kind of contact takes its place if it is useless: it
        // leads back against the last push, or if the body is flat, it is not shallow.
        private function findContactOfPush(shrunk:ShrunkBody, row:int, place:Vector3D, round:int, last:ContactPoint):void
        {
            // the contact of a flat body with a part that is as flat may point to either side
            var isSeparating:Boolean = shrunk.isFlat || round >= FIRST_SEPARATING_ROUND;
            shrunk.body.findContact(row, place, isSeparating, _contact);
            // exactly in the planes of a row, the way out of all its parts may be long
            var isUseless:Boolean = isSeparating ? !shrunk.body.isShallow(row, _contact) : leadsBack(_contact, last);
            if (isUseless && round < FIRST_SEPARATING_ROUND)
            {
                shrunk.body.findContact(row, place, !isSeparating, _contact);
            }
        }

        // Whether a push leads back against the last one, which is null at first. Then the body is between two rows.
        private static function leadsBack(push:ContactPoint, last:ContactPoint):Boolean
        {
            return last != null && push.normalX * last.normalX + push.normalY * last.normalY + push.normalZ * last.normalZ < OPPOSITE;
        }

        // Finds where the body touches a row: at its place, or if it is flat, half of a clearance beside its place along an axis. Returns whether it
        // touches the row at one of these.
        private static function findTouchingPlace(shrunk:ShrunkBody, row:int, place:Vector3D, touching:Vector3D):Boolean
        {
            touching.copyFrom(place);
            var touches:Boolean = shrunk.bodyTouches(row, touching);
            for (var i:int = 0; shrunk.isFlat && !touches && i < 6; i++)
            {
                var beside:Number = i < 3 ? -shrunk.clearance / 2 : shrunk.clearance / 2;
                var x:Number = i % 3 == 2 ? beside : 0;
                var y:Number = i % 3 == 1 ? beside : 0;
                var z:Number = i % 3 == 0 ? beside : 0;
                touching.setTo(place.x + x, place.y + y, place.z + z);
                touches = shrunk.bodyTouches(row, touching);
            }
            return touches;
        }
    }
}
