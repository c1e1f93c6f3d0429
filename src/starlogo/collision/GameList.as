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

        // Whether the list had its length, and each agent that was asked for its index. From the first change on, _indices has, by row, the last
        // known index, or -1 once the agent was missing.
        private var _isUnchanged:Boolean = true;
        private var _indices:Vector.<int> = new Vector.<int>();

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
            var firstRow:int = _pairs.rows[2 * pair];
            var secondRow:int = _pairs.rows[2 * pair + 1];
            var agents:Vector.<Agent> = _agents;
            var byRow:Vector.<Agent> = _pairs.list.agents;
            var ranks:Vector.<int> = _pairs.list.ranks;
            var isOfWorld:Boolean = secondRow < ListedAgents.FIRST_LISTED;
            if (_isUnchanged)
            {
                if (agents.length == _pairs.list.rows.count && agents[ranks[firstRow]] === byRow[firstRow]
                        && (isOfWorld || agents[ranks[secondRow]] === byRow[secondRow]))
                {
                    return true;
                }
                _isUnchanged = false;
                for (var row:int = 0; row < ranks.length; row++)
                {
                    _indices[row] = ranks[row];
                }
            }
            return has(firstRow) && (isOfWorld || has(secondRow));
        }

        // Once an agent was missing, it stays away for the rest of the frame. When agents are removed, others move towards the start of the
        // list, so an agent is looked for there first.
        private function has(row:int):Boolean
        {
            var agent:Agent = _pairs.list.agents[row];
            var index:int = _indices[row];
            if (index >= 0 && (index >= _agents.length || _agents[index] !== agent))
            {
                index = _agents.lastIndexOf(agent, index);
                if (index < 0)
                {
                    index = _agents.indexOf(agent);
                }
                _indices[row] = index;
            }
            return index >= 0;
        }
    }
}
