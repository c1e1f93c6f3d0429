package starlogo.queries.motion
{
    import flash.geom.Vector3D;
    import starlogo.convex.ContactPoint;
    import starlogo.data.IntList;
    import starlogo.engine;
    import starlogo.search.ModelShape;

    use namespace engine;

    /**
     * Gets a body out of what it overlaps. It frees the body's core where a motion begins (leaveOverlaps), leads the body off what it touches where its
     * motions end (restoreClearance), and tells a walk how deep the body is in others (measureOverlaps).
     *
     * <p>A shallow overlap comes from rounding in the game: the body is pushed out of it. If the body overlaps a row more deeply, the plane of their
     * contact stands for that row. The motion must not cross the plane, and nothing else of the row counts.</p>
     *
     * <p>The pushes go out of one row after the other, in rounds, because a push out of one side of a hollow leads a part of the way into
     * another. If it does not get free, for example between two opposite walls, it stays where it was. The tests of a pair know the shortest way
     * out of that pair (PairTests.separate).</p>
     *
     * @private
     */
    public final class OverlapRecovery
    {
        private static const MOST_ROUNDS:int = 30;

        // In place of a number of pushes: the body cannot be pushed out.
        private static const BLOCKED:int = -1;

        // From this round on contacts have to separate. Contacts of parts of a body may point sideways, round after round.
        private static const FIRST_SEPARATING_ROUND:int = 2;

        // If a body only touches a row, it is never this many slops deep in it.
        private static const SLOPS_OF_TOUCH:Number = 2;

        // Two normals are opposite if the cosine of the angle between them is less than this.
        private static const OPPOSITE:Number = -0.999;

        // The core of a body that stands, with its tolerances.
        private var _core:BodyCore = new BodyCore();

        // Where the pushes begin.
        private var _before:Vector3D = new Vector3D();

        // The contact of an overlap, or of this push, and that of the last push.
        private var _contact:ContactPoint = new ContactPoint();
        private var _last:ContactPoint = new ContactPoint();

        // A place where the body touches a row.
        private var _touching:Vector3D = new Vector3D();

        /**
         * Frees the core of a body from the obstacles that it overlaps where its motion starts.
         *
         * @param state how the motion starts. It receives the planes of deep overlaps. Obstacles for which a plane stands are none from then on. The
         *     place changes if the body is pushed
         */
        public function leaveOverlaps(state:MotionState):void
        {
            if (replaceObstacles(state, false) && !pushFree(state.core, state.obstacles, state.startPlace, false, state.pushes))
            {
                state.pushes.clear();
                replaceObstacles(state, true);
            }
            if (state.core.isFlat && state.planes.count == 0)
            {
                // its core is as flat, and a sweep touches across a wider gap than a body that stands
                pushFree(state.core, state.obstacles, state.startPlace, true, null);
            }
        }

        /**
         * Leads a body that stands a clearance off the rows that it touches, if there is room. A flat body is led also off those that it is close to. Rows
         * that it overlaps deeply do not count, nor one-way rows that it passes.
         *
         * @param place the place of the body, which changes
         */
        public function restoreClearance(body:MovingBody, rows:IntList, place:Vector3D):void
        {
            _core.beginStanding(body, rows, place);
            pushFree(_core, rows, place, true, null);
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
            _core.beginStanding(body, body.rows, place);
            for (var i:int = 0; i < body.rows.count; i++)
            {
                if (measureOverlap(_core, body.rows.numbers[i], place, _contact))
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

        // Pushes a body off the rows that it only touches, or else out of the shallow overlaps of its core. Goes from one row to the other until no more
        // pushes are needed. A list, which may be null, receives the pushes. Returns whether the body gets free. If not, it is where it was.
        private function pushFree(core:BodyCore, rows:IntList, place:Vector3D, isOff:Boolean, out:ContactList):Boolean
        {
            var round:int = 0;
            var count:int;
            _before.copyFrom(place);
            _last.setNormal(0, 0, 0);
            do
            {
                count = pushRound(core, rows, place, round, isOff, _last, out);
                round++;
            }
            while (count > 0 && round < MOST_ROUNDS);
            if (count != 0)
            {
                place.copyFrom(_before);
            }
            return count == 0;
        }

        // Pushes a body from each row once, if needed. The contact of the last push becomes that of the newest. Returns the number of pushes; BLOCKED if a
        // row is too deep, or pushes back.
        private function pushRound(core:BodyCore, rows:IntList, place:Vector3D, round:int, isOff:Boolean, last:ContactPoint, out:ContactList):int
        {
            var count:int = 0;
            for (var i:int = 0; i < rows.count; i++)
            {
                var row:int = rows.numbers[i];
                if (isOff ? findPushOff(core, row, place, round, last, _contact) : findPushOut(core, row, place, round, last, _contact))
                {
                    if (!(_contact.depth < Infinity) || areOpposite(_contact, last))
                    {
                        return BLOCKED;
                    }
                    _contact.push(place, _contact.depth);
                    last.copyFrom(_contact);
                    if (out != null)
                    {
                        out.add(_contact, row);
                    }
                    count++;
                }
            }
            return count;
        }

        // Lets planes stand for obstacles that the core overlaps: for deep overlaps, and also for shallow ones if they are to count. These are obstacles no
        // longer, nor are one-way rows that the body passes. Returns whether obstacles are left that the core overlapped.
        private function replaceObstacles(state:MotionState, alsoShallow:Boolean):Boolean
        {
            var obstacles:IntList = state.obstacles;
            var isLeft:Boolean = false;
            var i:int = 0;
            while (i < obstacles.count)
            {
                var row:int = obstacles.numbers[i];
                var isOverlapped:Boolean = state.core.coreTouches(row, state.startPlace);
                if (isOverlapped && (state.core.body.passesOneWayAt(row, state.startPlace) || addPlane(row, state, alsoShallow)))
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

        // Lets a plane stand for a row that the core overlaps, if the overlap counts and a plane is needed. First the core becomes narrower, for the whole
        // motion. If it is free of the row then, no plane is needed. None is needed either if only the core overlaps the row, not the body. Returns whether
        // the plane stands.
        private function addPlane(row:int, state:MotionState, alsoShallow:Boolean):Boolean
        {
            var core:BodyCore = state.core;
            if (!findOverlap(core.body, row, state.startPlace, alsoShallow, _contact) || core.narrow(row, state.startPlace)
                    || !core.bodyOverlaps(row, state.startPlace))
            {
                return false;
            }
            state.planes.add(_contact, row);
            core.body.warnIfInside(row, _contact);
            return true;
        }

        // Finds the contact of an overlap. Returns whether it counts.
        private static function findOverlap(body:MovingBody, row:int, place:Vector3D, alsoShallow:Boolean, out:ContactPoint):Boolean
        {
            if (alsoShallow)
            {
                body.findSeparatingContact(row, place, out);
                return true;
            }
            body.findContact(row, place, out);
            return !body.isShallow(row, out);
        }

        // Finds the push out of a row that the core overlaps: along the contact's normal by its depth, which is Infinity if the overlap is deep. Returns whether
        // the core overlaps the row.
        private static function findPushOut(core:BodyCore, row:int, place:Vector3D, round:int, last:ContactPoint, out:ContactPoint):Boolean
        {
            if (!core.coreTouches(row, place))
            {
                return false;
            }
            findContactInRound(core.body, row, place, round, last, out);
            out.depth = core.body.isShallow(row, out) ? out.depth + core.clearance : Infinity;
            return true;
        }

        // Finds the push off a row that the body touches: along the contact's normal by its depth. Returns whether there is one: not if the body overlaps the
        // row deeply, or passes it.
        private function findPushOff(core:BodyCore, row:int, place:Vector3D, round:int, last:ContactPoint, out:ContactPoint):Boolean
        {
            var body:MovingBody = core.body;
            // mostly it is known faster that the core touches the row than how deep the overlap is
            if (!findTouchingPlace(core, row, place, _touching) || body.passesOneWayAt(row, _touching) || (!core.isFlat && core.coreTouches(row, place)))
            {
                return false;
            }
            findContactInRound(body, row, _touching, round, last, out);
            var most:Number = SLOPS_OF_TOUCH * core.slop;
            if (out.depth > most && !body.isShallow(row, out))
            {
                return false;
            }
            var beside:Number = out.normalX * (place.x - _touching.x) + out.normalY * (place.y - _touching.y) + out.normalZ * (place.z - _touching.z);
            out.depth = Math.min(out.depth, most) + core.clearance - beside;
            return true;
        }

        // Finds the contact with a row that the body touches at a place. It does not lead back against the last push if another contact does not.
        private static function findContactInRound(body:MovingBody, row:int, place:Vector3D, round:int, last:ContactPoint, out:ContactPoint):void
        {
            if (round < FIRST_SEPARATING_ROUND)
            {
                body.findContact(row, place, out);
            }
            if (round >= FIRST_SEPARATING_ROUND || areOpposite(out, last))
            {
                body.findSeparatingContact(row, place, out);
            }
        }

        // Finds an overlap that a walk begins with a push out of: see measureOverlaps. Returns whether it counts.
        private static function measureOverlap(core:BodyCore, row:int, place:Vector3D, out:ContactPoint):Boolean
        {
            var body:MovingBody = core.body;
            if (body.isOneWay(row) || !core.coreTouches(row, place))
            {
                return false;
            }
            body.findSeparatingContact(row, place, out);
            if (body.isShallow(row, out) || !core.bodyOverlaps(row, place))
            {
                return false;
            }
            body.warnIfInside(row, out);
            out.depth += core.clearance;
            // the shortest way out of a tree may lead through a wall of the tree if it is longer than the way to the middle of the body
            return body.bodyOf(row).form != ModelShape.TREE || out.depth <= body.whole.halfAlong(out);
        }

        // Whether a body that has both contacts is between two rows.
        private static function areOpposite(a:ContactPoint, b:ContactPoint):Boolean
        {
            return a.normalX * b.normalX + a.normalY * b.normalY + a.normalZ * b.normalZ < OPPOSITE;
        }

        // Finds where the body touches a row: at its place, or if it is flat, half of a clearance beside its place along an axis. Returns whether it
        // touches the row at one of these.
        private static function findTouchingPlace(core:BodyCore, row:int, place:Vector3D, touching:Vector3D):Boolean
        {
            if (touchesAt(core, row, place, 0, 0, 0, touching))
            {
                return true;
            }
            if (!core.isFlat)
            {
                return false;
            }
            var side:Number = -core.clearance / 2;
            for (var i:int = 0; i < 2; i++)
            {
                if (touchesAt(core, row, place, 0, 0, side, touching) || touchesAt(core, row, place, 0, side, 0, touching)
                        || touchesAt(core, row, place, side, 0, 0, touching))
                {
                    return true;
                }
                side = -side;
            }
            return false;
        }

        // Sets the touching place to a place moved by x, y and z. Returns whether the body touches a row there.
        private static function touchesAt(core:BodyCore, row:int, place:Vector3D, x:Number, y:Number, z:Number, touching:Vector3D):Boolean
        {
            touching.setTo(place.x + x, place.y + y, place.z + z);
            return core.bodyTouches(row, touching);
        }
    }
}
