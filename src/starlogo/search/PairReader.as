package starlogo.search
{
    import starlogo.agents.Agent;
    import starlogo.data.IntPairMap;
    import starlogo.data.requireGiven;
    import starlogo.search.table.ListedAgents;

    /**
     * Reads the pairs of a collision system that is not the engine's: pairs of agents become pairs of rows. It checks the list of the frame, and what
     * the system has found.
     *
     * @private
     */
    public final class PairReader
    {
        private var _pairs:FoundPairs = new FoundPairs(new ListedAgents());

        // The pairs that have been read, by their rows, the lesser first.
        private var _known:IntPairMap = new IntPairMap();

        /**
         * Begins with the list of a frame.
         *
         * @throws ArgumentError if an agent is null or listed twice
         */
        public function begin(list:Vector.<Agent>):void
        {
            _pairs.listed.propose(list);
            _pairs.listed.accept(list);
        }

        /**
         * Reads pairs of listed agents. They keep their order.
         *
         * @param pairs the pairs: a0, b0, a1, b1, ...
         * @return the pairs as rows. The next call overwrites them
         * @throws ArgumentError if there are no pairs, a half pair, an agent that is null or not in the list, an agent with itself, or a pair twice,
         *     in either order
         */
        public function read(pairs:Vector.<Agent>):FoundPairs
        {
            requireGiven("what the collision system has found", pairs);
            if (pairs.length % 2 != 0)
            {
                throw new ArgumentError("the collision system has found pairs of " + pairs.length + " agents: that must be an even number");
            }
            _pairs.count = 0;
            _known.clear();
            for (var i:int = 0; i < pairs.length; i += 2)
            {
                var a:int = rowAt(i, pairs);
                var b:int = rowAt(i + 1, pairs);
                if (a == b)
                {
                    throw new ArgumentError("the collision system has found " + pairs[i] + " with itself: it is at " + i + " and " + (i + 1) +
                            " of what it has found");
                }
                if (_known.set (Math.min(a, b), Math.max(a, b), i) >= 0)
                {
                    throw new ArgumentError("the collision system has found " + pairs[i] + " and " + pairs[i + 1] + " twice: the second time at " + i +
                            " of what it has found");
                }
                _pairs.add(a, b);
            }
            return _pairs;
        }

        private function rowAt(index:int, pairs:Vector.<Agent>):int
        {
            var agent:Agent = pairs[index];
            if (agent == null)
            {
                throw new ArgumentError("the collision system has found no agent: " + index + " of what it has found is null");
            }
            var row:int = _pairs.listed.rowOf(agent);
            if (row < 0)
            {
                throw new ArgumentError("the collision system has found " + agent + ", which is not in the list of the frame");
            }
            return row;
        }
    }
}
