package starlogo.search
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.broadphase.BinLevel;
    import starlogo.broadphase.PairSink;
    import starlogo.broadphase.Extents;
    import starlogo.convex.RelativeMotion;
    import starlogo.data.IntList;
    import starlogo.engine;
    import starlogo.search.table.AgentTable;
    import starlogo.search.table.ListedAgents;

    use namespace engine;

    /**
     * Tests the candidates that the broad phase has found, and all members with the ground and the edges of the world: where they are, or on their
     * motions if an agent of the search sweeps. It adds the pairs that touch, and whose breeds are of interest, to the found ones.
     */
    internal final class CandidateTests extends PairSink
    {
        private var _table:AgentTable;
        private var _narrowPhase:NarrowPhase;
        private var _motions:RowMotions;

        // The pairs of breeds that count in the search under way, or null if all of agents do; and what takes the pairs that it finds.
        private var _interests:BreedInterests = null;
        private var _out:FoundPairs = null;

        // The motion of a pair that is tested.
        private var _motion:RelativeMotion = new RelativeMotion();

        /**
         * @param table has the rows
         * @param narrowPhase tests their bodies
         * @param motions those of the rows
         */
        public function CandidateTests(table:AgentTable, narrowPhase:NarrowPhase, motions:RowMotions)
        {
            _table = table;
            _narrowPhase = narrowPhase;
            _motions = motions;
        }

        /** Begins a search. @param out receives the pairs, row by row. They are not in order then */
        public function begin(input:SearchInput, out:FoundPairs):void
        {
            out.count = 0;
            _interests = input.interests.includesAllOfAgents() ? null : input.interests;
            _out = out;
        }

        /** @inheritDoc */
        override public function onCandidates(row:int, others:Vector.<int>, count:int, level:BinLevel):void
        {
            if (_interests != null)
            {
                count = _interests.keepOfInterest(_table.breeds, row, others, count);
            }
            _narrowPhase.counts.candidatePairs += count;
            addTouching(row, others, count, level);
        }

        /**
         * Tests the members among some rows with the ground, or with the edges of the world, if there are any and handlers for them.
         *
         * @param environmentRow GROUND_ROW or EDGES_ROW of ListedAgents
         * @param rows the rows; those that are no members are left out
         * @param input as in begin()
         */
        public function testWithEnvironment(environmentRow:int, rows:IntList, input:SearchInput):void
        {
            if (_table.listed.agentsByRow[environmentRow] == null || !input.interests.isNamed(_table.breeds[environmentRow]))
            {
                return;
            }
            var members:IntList = input.membersAmong(rows, _table);
            var count:int = input.interests.keepOfInterest(_table.breeds, environmentRow, members.values, members.count);
            addTouching(environmentRow, members.values, count, BinLevel.ANY_GAP);
        }

        // Adds the pairs of a row with those candidates that touch it.
        private function addTouching(row:int, others:Vector.<int>, count:int, level:BinLevel):void
        {
            count = _motions.anySweeps ? keepTouchingOnMotions(row, others, count, level) : keepTouching(row, others, count, level);
            _out.addPairs(row, others, count);
        }

        // Keeps the rows that touch a row, and moves them to the beginning of the list.
        private function keepTouching(row:int, others:Vector.<int>, count:int, level:BinLevel):int
        {
            // a field would be read again for each candidate
            var table:AgentTable = _table;
            var narrowPhase:NarrowPhase = _narrowPhase;
            if (narrowPhase.shapeChoice.areSpheres && row >= ListedAgents.FIRST_LISTED)
            {
                return narrowPhase.sphereTests.keepTouchingSpheres(table, row, others, count, level);
            }
            var body:Body = table.bodyOf(row);
            var extents:Extents = table.extents;
            var slack:Number = level.slack;
            var kept:int = 0;
            for (var i:int = 0; i < count; i++)
            {
                var other:int = others[i];
                if (extents.areNear(row, other, slack) && narrowPhase.areTouching(body, table.bodyOf(other)))
                {
                    others[kept] = other;
                    kept++;
                }
            }
            return kept;
        }

        // Keeps the rows that touch a row on their motions, moves them to the beginning of the list, and notes the times of their touches. The level has the
        // slack of the rows' extents. It is no Number, because V8 would make an object for each row.
        private function keepTouchingOnMotions(row:int, others:Vector.<int>, count:int, level:BinLevel):int
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
                    _out.setTime(kept, _motion);
                    kept++;
                }
            }
            return kept;
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
                motion.time = areTouching(a, b) ? _motions.timeOfCommonMotion(a) : RelativeMotion.NEVER;
            }
            else if (_table.shapes[a].kind == BoundingStructure.SPHERE && _table.shapes[b].kind == BoundingStructure.SPHERE)
            {
                _narrowPhase.counts.sweptPairs++;
                _narrowPhase.sphereTests.findTimeOfRows(_table, a, b, motion);
            }
            else if (areNearOnMotion(a, b, level, motion))
            {
                var bodyA:Body = _table.bodyOf(a);
                var bodyB:Body = _table.bodyOf(b);
                _narrowPhase.counts.sweptPairs++;
                _narrowPhase.pairTestsFor(bodyA, bodyB).findFirstTouch(bodyA, bodyB, motion, null);
            }
        }

        // Whether two rows touch where they are. Only the second may be the ground or the edges.
        private function areTouching(a:int, b:int):Boolean
        {
            return _narrowPhase.areTouching(_table.bodyOf(a), _table.bodyOf(b));
        }

        // Whether the extents of a row's whole motion, which ends where the row is, overlap another row's extents, or nearly do. The motion is relative to
        // the other row.
        private function areNearOnMotion(a:int, b:int, level:BinLevel, motion:RelativeMotion):Boolean
        {
            var extents:Extents = _table.extents;
            return Math.abs(extents.x[a] - extents.x[b] - motion.x / 2) <= extents.halfX[a] + extents.halfX[b] + Math.abs(motion.x) / 2 + level.slack
                && Math.abs(extents.y[a] - extents.y[b] - motion.y / 2) <= extents.halfY[a] + extents.halfY[b] + Math.abs(motion.y) / 2 + level.slack
                && Math.abs(extents.z[a] - extents.z[b] - motion.z / 2) <= extents.halfZ[a] + extents.halfZ[b] + Math.abs(motion.z) / 2 + level.slack;
        }
    }
}
