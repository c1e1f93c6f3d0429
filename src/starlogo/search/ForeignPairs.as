package starlogo.search
{
    import starlogo.agents.Agent;
    import starlogo.data.HashTable;
    import starlogo.engine;
    import starlogo.search.table.ListedAgents;

    use namespace engine;

    /**
     * Reads the pairs of a collision system that is not the engine's: pairs of agents become pairs of rows. The agents of the list have rows in its
     * order.
     *
     * @private
     */
    public final class ForeignPairs
    {
        // The rows of agents by their ids; and by row the agents and their indices.
        private var _rowsById:HashTable = new HashTable();
        private var _agents:Vector.<Agent> = new Vector.<Agent>();
        private var _ranks:Vector.<int> = new Vector.<int>();

        private var _pairs:FoundPairs = new FoundPairs();

        /**
         * Reads pairs. It leaves out a pair if one of its agents is not in the list.
         *
         * @param pairs the pairs: a0, b0, a1, b1, ...
         * @param list the list of the frame
         * @return the pairs as rows. The next call overwrites them
         */
        public function read(pairs:Vector.<Agent>, list:Vector.<Agent>):FoundPairs
        {
            readList(list);
            _pairs.begin(_agents, _ranks, list.length);
            for (var i:int = 0; i + 1 < pairs.length; i += 2)
            {
                var a:int = _rowsById.valueOf(pairs[i].id, 0);
                var b:int = _rowsById.valueOf(pairs[i + 1].id, 0);
                if (a >= 0 && b >= 0)
                {
                    _pairs.add(a, b);
                }
            }
            return _pairs;
        }

        private function readList(list:Vector.<Agent>):void
        {
            _rowsById.clear();
            _agents.length = _ranks.length = ListedAgents.FIRST_LISTED + list.length;
            for (var i:int = 0; i < list.length; i++)
            {
                var row:int = ListedAgents.FIRST_LISTED + i;
                _agents[row] = list[i];
                _ranks[row] = i;
                if (list[i] != null)
                {
                    _rowsById.set (list[i].id, 0, row);
                }
            }
        }
    }
}
