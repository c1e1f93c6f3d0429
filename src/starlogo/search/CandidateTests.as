package starlogo.search
{
    import starlogo.broadphase.BinLevel;
    import starlogo.broadphase.PairSink;
    import starlogo.broadphase.Extents;
    import starlogo.data.IntList;
    import starlogo.engine;
    import starlogo.search.table.AgentTable;
    import starlogo.search.table.ListedAgents;

    use namespace engine;

    /**
     * Tests the candidates that the broad phase has found, and all members with the ground and the edges of the world. It adds the pairs that touch, and
     * whose breeds are of interest, to the found ones.
     */
    internal final class CandidateTests extends PairSink
    {
        private var _table:AgentTable;
        private var _narrowPhase:NarrowPhase;
        private var _sweptTests:SweptTests;

        // The input of the search under way.
        private var _input:SearchInput = null;

        // Takes the pairs of this search, and their times if an agent sweeps.
        private var _out:FoundPairs = null;
        private var _times:Vector.<Number> = null;

        // The members that are tested with the ground or the edges of the world.
        private var _environmentCandidates:IntList = new IntList();

        /**
         * @param table has the rows
         * @param narrowPhase tests their bodies
         * @param sweptTests tests rows on their motions, if an agent sweeps. Otherwise rows are tested where they are
         */
        public function CandidateTests(table:AgentTable, narrowPhase:NarrowPhase, sweptTests:SweptTests)
        {
            _table = table;
            _narrowPhase = narrowPhase;
            _sweptTests = sweptTests;
        }

        /**
         * Begins a search.
         *
         * @param out receives the pairs, row by row. They are not in order then
         * @param times receives by pair the time of the touch; null if no agent sweeps
         */
        public function begin(input:SearchInput, out:FoundPairs, times:Vector.<Number>):void
        {
            out.count = 0;
            _input = input;
            _out = out;
            _times = times;
        }

        /** @inheritDoc */
        override public function onCandidates(row:int, others:Vector.<int>, count:int, level:BinLevel):void
        {
            var interests:BreedInterests = _input.interests;
            if (!interests.includesAllOfAgents)
            {
                count = interests.keepOfInterest(_table.breeds, row, others, count);
            }
            _narrowPhase.counts.candidatePairs += count;
            addTouching(row, others, count, level);
        }

        /**
         * Tests the members among some rows with the ground, or with the edges of the world, if there are any and handlers for them.
         *
         * @param environmentRow GROUND_ROW or EDGES_ROW of ListedAgents
         * @param rows the rows; those that are no members are left out
         */
        public function testWithEnvironment(environmentRow:int, rows:IntList):void
        {
            if (_table.listed.agentsByRow[environmentRow] == null || !_input.interests.isNamed(_table.breeds[environmentRow]))
            {
                return;
            }
            _input.copyMembers(rows, _table, _environmentCandidates);
            var others:Vector.<int> = _environmentCandidates.values;
            var count:int = _input.interests.keepOfInterest(_table.breeds, environmentRow, others, _environmentCandidates.count);
            addTouching(environmentRow, others, count, BinLevel.ANY_GAP);
        }

        // Adds the pairs of a row with those candidates that touch it.
        private function addTouching(row:int, others:Vector.<int>, count:int, level:BinLevel):void
        {
            count = _times == null ? keepTouching(row, others, count, level)
                : _sweptTests.keepTouchingOnMotions(row, others, count, level, _times, _out.count);
            _out.addPairs(row, others, count);
        }

        // Keeps the rows that touch a row, and moves them to the beginning of the list.
        private function keepTouching(row:int, others:Vector.<int>, count:int, level:BinLevel):int
        {
            // a field would be read again for each candidate
            var table:AgentTable = _table;
            var narrowPhase:NarrowPhase = _narrowPhase;
            if (narrowPhase.choice.areSpheres && row >= ListedAgents.FIRST_LISTED)
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
    }
}
