package starlogo.collision
{
    import starlogo.agents.Agent;
    import starlogo.search.FoundPairs;
    import starlogo.search.table.ListedAgents;

    /** The game's own list of a frame, which handlers may change. It knows which agents are still in it. */
    internal final class GameList
    {
        private var _agents:Vector.<Agent> = null;
        private var _pairs:FoundPairs = null;

        // By row: the last known index, or -1 once the agent was missing. Before an agent was found elsewhere, the ranks are the indices.
        private var _indices:Vector.<int> = new Vector.<int>();
        private var _isUnchanged:Boolean = true;

        /**
         * Begins a frame.
         *
         * @param agents the list
         * @param pairs have the rows of its agents
         */
        public function begin(agents:Vector.<Agent>, pairs:FoundPairs):void
        {
            _agents = agents;
            _pairs = pairs;
            _isUnchanged = true;
        }

        /** Ends the frame. */
        public function end():void
        {
            _agents = null;
            _pairs = null;
        }

        /** Whether both agents of a pair are in the list. The ground and the edges of the world always are. */
        public function hasBoth(pair:int):Boolean
        {
            return findRow(_pairs.rows[2 * pair]) && findRow(_pairs.rows[2 * pair + 1]);
        }

        // Finds the agent of a row, and notes where it is. Once it was missing, it stays away for the rest of the frame. When agents are removed,
        // others move towards the start of the list, so an agent is looked for there first.
        private function findRow(row:int):Boolean
        {
            if (row < ListedAgents.FIRST_LISTED)
            {
                return true;
            }
            var agent:Agent = _pairs.list.agents[row];
            var index:int = _isUnchanged ? _pairs.list.ranks[row] : _indices[row];
            if (index >= 0 && (index >= _agents.length || _agents[index] !== agent))
            {
                copyRanks();
                index = _agents.lastIndexOf(agent, index);
                if (index < 0)
                {
                    index = _agents.indexOf(agent);
                }
                _indices[row] = index;
            }
            return index >= 0;
        }

        private function copyRanks():void
        {
            var ranks:Vector.<int> = _pairs.list.ranks;
            for (var row:int = 0; _isUnchanged && row < ranks.length; row++)
            {
                _indices[row] = ranks[row];
            }
            _isUnchanged = false;
        }
    }
}
