package starlogo.search
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.broadphase.BinLevel;
    import starlogo.broadphase.Extents;
    import starlogo.broadphase.Points;
    import starlogo.convex.ContactPoint;
    import starlogo.convex.RelativeMotion;
    import starlogo.engine;
    import starlogo.intersection.boxes.ContactInterval;
    import starlogo.search.pairs.PairTests;
    import starlogo.search.table.AgentTable;

    use namespace engine;

    /**
     * Finds when and how two rows touch on their motions, in a search in which an agent sweeps. Two rows that do not sweep are tested where they are.
     */
    internal final class SweptTests
    {
        private var _table:AgentTable;
        private var _narrowPhase:NarrowPhase;
        private var _motions:RowMotions;

        // The motion of a pair that is tested.
        private var _motion:RelativeMotion = new RelativeMotion();

        // When the extents of a pair overlap, in all directions so far.
        private var _interval:ContactInterval = new ContactInterval();

        /**
         * @param table has the rows
         * @param narrowPhase tests their bodies
         * @param motions those of the rows
         */
        public function SweptTests(table:AgentTable, narrowPhase:NarrowPhase, motions:RowMotions)
        {
            _table = table;
            _narrowPhase = narrowPhase;
            _motions = motions;
        }

        /**
         * Keeps the rows that touch a row on their motions, and moves them to the beginning of the list.
         *
         * @param others the rows to test
         * @param count the number of these
         * @param level has the slack of the rows' extents; BinLevel.ANY_GAP for the ground and the edges. It is no Number, because V8 would make an object
         *     for each row
         * @param times receives the times of the touches
         * @param from the index of the first of them
         * @return the number of rows that it keeps
         */
        public function keepTouchingOnMotions(row:int, others:Vector.<int>, count:int, level:BinLevel, times:Vector.<Number>,
                from:int):int
        {
            var listIndices:Vector.<int> = _table.listed.listIndices;
            var index:int = listIndices[row];
            var kept:int = 0;
            for (var i:int = 0; i < count; i++)
            {
                var other:int = others[i];
                // the time belongs to the motion of the agent that comes first in the list, relative to the other
                var isFirst:Boolean = index < listIndices[other];
                findTime(isFirst ? row : other, isFirst ? other : row, level, _motion);
                if (_motion.time != RelativeMotion.NEVER)
                {
                    others[kept] = other;
                    times[int(from + kept)] = _motion.time;
                    kept++;
                }
            }
            return kept;
        }

        /**
         * Finds the contact of two rows that touch, which separates them: on their motions if one of the two sweeps, or else where they are.
         *
         * @param b may be the ground or the edges of the world
         * @param motion receives the motion of the first relative to the second, with the time
         * @param out receives the contact at that time
         */
        public function findContact(a:int, b:int, motion:RelativeMotion, out:ContactPoint):void
        {
            var bodyA:Body = _table.bodyOf(a);
            var bodyB:Body = _table.bodyOf(b);
            var tests:PairTests = _narrowPhase.pairTestsFor(bodyA, bodyB);
            _motions.setRelativeMotion(a, b, motion);
            if (_motions.eitherSweeps(a, b))
            {
                if (!motion.isStill)
                {
                    tests.findFirstTouch(bodyA, bodyB, motion, out);
                }
                else if (tests.areTouching(bodyA, bodyB))
                {
                    motion.time = timeOfCommonMotion(a);
                    tests.findContactOfParts(bodyA, bodyB, motion, out);
                }
            }
            if (motion.time == RelativeMotion.NEVER)
            {
                tests.findContact(bodyA, bodyB, motion, out);
                return;
            }
            tests.separate(bodyA, bodyB, motion, out);
            // the motion was relative to b at its present place, so the point is moved back to where b was at that time
            var back:Number = motion.time - 1;
            out.x += back * _motions.displacements.x[b];
            out.y += back * _motions.displacements.y[b];
            out.z += back * _motions.displacements.z[b];
        }

        // Finds the time at which two rows first touch, from 0 to 1, or RelativeMotion.NEVER. If neither of the two sweeps, they are tested where they are
        // now. The motion becomes that of the first relative to the second, with the time.
        private function findTime(a:int, b:int, level:BinLevel, motion:RelativeMotion):void
        {
            _motions.setRelativeMotion(a, b, motion);
            if (!_motions.eitherSweeps(a, b))
            {
                motion.time = _table.extents.areNear(a, b, level.slack) && areTouching(a, b) ? 1 : RelativeMotion.NEVER;
            }
            else if (motion.isStill)
            {
                motion.time = areTouching(a, b) ? timeOfCommonMotion(a) : RelativeMotion.NEVER;
            }
            else
            {
                sweep(a, b, level, motion);
            }
        }

        // The time at which two rows that touch first do, if the first does not move relative to the second: from the beginning on if they move alike,
        // and where they are if they have not moved.
        private function timeOfCommonMotion(a:int):int
        {
            var displacements:Points = _motions.displacements;
            return displacements.x[a] != 0 || displacements.y[a] != 0 || displacements.z[a] != 0 ? 0 : 1;
        }

        // Whether two rows touch where they are. Only the second may be the ground or the edges.
        private function areTouching(a:int, b:int):Boolean
        {
            return _narrowPhase.areTouching(_table.bodyOf(a), _table.bodyOf(b));
        }

        private function sweep(a:int, b:int, level:BinLevel, motion:RelativeMotion):void
        {
            var areSpheres:Boolean = _table.shapes[a].kind == BoundingStructure.SPHERE && _table.shapes[b].kind == BoundingStructure.SPHERE;
            if (!areSpheres && !overlapOnMotions(a, b, level))
            {
                return;
            }
            _narrowPhase.counts.sweptPairs++;
            if (areSpheres)
            {
                _narrowPhase.sphereTests.findTimeOfRows(_table, a, b, motion);
                return;
            }
            var bodyA:Body = _table.bodyOf(a);
            var bodyB:Body = _table.bodyOf(b);
            _narrowPhase.pairTestsFor(bodyA, bodyB).findFirstTouch(bodyA, bodyB, motion, null);
        }

        // Whether the extents of two rows overlap in all directions at the same time, on their motions.
        private function overlapOnMotions(a:int, b:int, level:BinLevel):Boolean
        {
            var standing:Extents = _table.extents;
            _interval.reset(1);
            _interval.margin = level.slack;
            return narrow(standing.x, standing.halfX, _motions.displacements.x, a, b) && narrow(standing.y, standing.halfY, _motions.displacements.y, a, b)
                && narrow(standing.z, standing.halfZ, _motions.displacements.z, a, b);
        }

        // Narrows the interval by one direction. It gets the places at the end of the motions, half the lengths, and the motions.
        private function narrow(at:Vector.<Number>, half:Vector.<Number>, motion:Vector.<Number>, a:int, b:int):Boolean
        {
            // The reverse of what ContactInterval names: row a seen from row b. The interval is the same.
            var speed:Number = motion[a] - motion[b];
            _interval.offset = at[a] - at[b] - speed;
            _interval.speed = speed;
            _interval.halfExtents = half[a] + half[b];
            return _interval.narrow();
        }
    }
}
