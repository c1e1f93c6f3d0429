package starlogo.search
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.broadphase.BinLevel;
    import starlogo.broadphase.Extents;
    import starlogo.broadphase.PairSink;
    import starlogo.convex.RelativeMotion;
    import starlogo.data.IntList;
    import starlogo.engine;
    import starlogo.search.pairs.PairTests;
    import starlogo.search.table.AgentTable;

    use namespace engine;

    /**
     * Finds the pairs of rows that touch and whose breeds are of interest, among the candidates that the broad phase gives it. Agents that
     * sweep are tested along their motions.
     */
    internal final class PairFinder extends PairSink
    {
        // In place of a form: none.
        private static const NONE:int = -1;

        /** The number of candidates whose breeds are of interest. */
        public var candidatePairs:int = 0;

        /** The number of pairs that touch before the end of their motions. In the order of the pairs they come first. */
        public var earlyPairs:int = 0;

        private var _table:AgentTable;
        private var _motions:RowMotions;
        private var _sorter:PairSorter = new PairSorter();

        // The input of the search under way, and what takes the pairs.
        private var _input:FrameInput = null;
        private var _out:FoundPairs = null;

        // By pair, if an agent sweeps: the time of the touch, in the order in which the pairs are found.
        private var _times:Vector.<Number> = new Vector.<Number>();

        // The motion of a pair that is tested.
        private var _motion:RelativeMotion = new RelativeMotion();

        // The members that are tested with the ground or the edges of the world.
        private var _members:IntList = new IntList();

        /**
         * @param table has the rows, and the tests of which of them touch
         * @param motions of the rows, if an agent sweeps
         */
        public function PairFinder(table:AgentTable, motions:RowMotions)
        {
            _table = table;
            _motions = motions;
        }

        /** Begins a search. @param out receives the pairs */
        public function begin(input:FrameInput, out:FoundPairs):void
        {
            candidatePairs = earlyPairs = 0;
            out.begin();
            _input = input;
            _out = out;
        }

        /** Ends the search: puts the pairs into order. */
        public function end():void
        {
            _sorter.sort(_out, _motions.areNeeded ? _times : null);
        }

        /** @inheritDoc */
        override public function onCandidates(row:int, others:Vector.<int>, count:int, level:BinLevel):void
        {
            var interests:BreedInterests = _input.interests;
            if (interests != null && !interests.includesAllOfAgents)
            {
                count = interests.keepOfInterest(_table.breeds, row, others, count);
            }
            candidatePairs += count;
            var kept:int = _motions.areNeeded ? keepTouchingMotions(row, others, count, level) : keepTouching(row, others, count, level);
            _out.addPairs(row, others, kept);
        }

        /**
         * Finds the pairs of rows with the ground, or with the edges of the world, if these take part. It tests only members whose breeds are of
         * interest together with the breed of the ground or of the edges.
         *
         * @param worldRow the row of the ground or of the edges
         * @param rows the rows
         */
        public function findPairsOfWorldAgent(worldRow:int, rows:IntList):void
        {
            if (_table.list.agents[worldRow] == null || !_input.interests.isNamed(_table.breeds[worldRow]))
            {
                return;
            }
            _input.listMembers(_table, rows, _members);
            var others:Vector.<int> = _members.numbers;
            var count:int = _input.interests.keepOfInterest(_table.breeds, worldRow, others, _members.count);
            var kept:int = _motions.areNeeded ? keepTouchingMotions(worldRow, others, count, null)
                : keepTouchingWorld(worldRow, others, count);
            _out.addPairs(worldRow, others, kept);
        }

        // Keeps the rows that touch a row, and moves them to the beginning of the list. The level has the slack of their extents.
        private function keepTouching(row:int, others:Vector.<int>, count:int, level:BinLevel):int
        {
            var table:AgentTable = _table;
            var tests:NarrowPhase = table.narrowPhase;
            if (tests.choice.areSpheres)
            {
                return tests.sphereTests.keepTouching(table, level, row, others, count);
            }
            var body:Body = table.bodyOf(row);
            var extents:Extents = table.extents;
            var slack:Number = level.slack;
            // two spheres or two boxes need no test of their extents, except for the heights
            var quickForm:int = body.form == BoundingStructure.SPHERE || body.form == BoundingStructure.BOX ? body.form : NONE;
            var kept:int = 0;
            for (var i:int = 0; i < count; i++)
            {
                var other:int = others[i];
                var isNear:Boolean = table.shapes[other].form == quickForm ? extents.areHeightsNear(row, other, slack) : extents.areNear(row, other, slack);
                if (isNear && tests.areTouching(body, table.bodyOf(other)))
                {
                    others[kept] = other;
                    kept++;
                }
            }
            return kept;
        }

        // Keeps the rows that touch the ground or the edges of the world.
        private function keepTouchingWorld(worldRow:int, others:Vector.<int>, count:int):int
        {
            var world:Body = _table.bodyOf(worldRow);
            var tests:PairTests = _table.narrowPhase.pairTestsForWorldAgent(world);
            var kept:int = 0;
            for (var i:int = 0; i < count; i++)
            {
                if (tests.areTouching(_table.bodyOf(others[i]), world))
                {
                    others[kept] = others[i];
                    kept++;
                }
            }
            return kept;
        }

        // Keeps the rows that touch a row on their motions, and notes the times of their pairs, which are added next. The level is null for the ground
        // and the edges, whose extents say nothing.
        private function keepTouchingMotions(row:int, others:Vector.<int>, count:int, level:BinLevel):int
        {
            var ranks:Vector.<int> = _table.list.ranks;
            var rank:int = ranks[row];
            var times:Vector.<Number> = _times;
            var before:int = _out.count;
            var kept:int = 0;
            for (var i:int = 0; i < count; i++)
            {
                var other:int = others[i];
                // the time belongs to the motion of the agent that comes first in the list, relative to the other
                var isFirst:Boolean = rank < ranks[other];
                _motions.findFirst(level, isFirst ? row : other, isFirst ? other : row, _motion);
                if (_motion.time != RelativeMotion.NEVER)
                {
                    others[kept] = other;
                    times[int(before + kept)] = _motion.time;
                    kept++;
                    if (_motion.time < 1)
                    {
                        earlyPairs++;
                    }
                }
            }
            return kept;
        }
    }
}
