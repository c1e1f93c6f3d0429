package starlogo.collision
{
    import starlogo.agents.Agent;
    import starlogo.search.FoundPairs;
    import starlogo.search.table.ListedAgents;

    /** The game's own list of a frame, which handlers may change. It knows which agents are still in it. */
    internal final class GameList
    {
        private var _agents:Vector.<Agent> = null;

        // By row: the last known index, or -1 once the agent was missing.
        private var _indices:Vector.<int> = new Vector.<int>();

        /** Begins a frame with its list. @param listed the agents as the frame has found them in the list */
        public function begin(agents:Vector.<Agent>, listed:ListedAgents):void
        {
            _agents = agents;
            var indices:Vector.<int> = listed.listIndices;
            for (var row:int = 0; row < indices.length; row++)
            {
                _indices[row] = indices[row];
            }
        }

        /**
         * Looks for both agents of a pair in the list. Returns whether they are still there. An agent that is missing once stays away for the rest of the frame. The ground and the
         * edges of the world are always there. They come second in a pair.
         */
        public function findBoth(pairs:FoundPairs, pair:int):Boolean
        {
            var second:int = pairs.rows[2 * pair + 1];
            return findIndex(pairs.listed, pairs.rows[2 * pair]) >= 0 && (second < ListedAgents.FIRST_LISTED || findIndex(pairs.listed, second) >= 0);
        }

        // Finds the index of a row's agent, and notes it. When agents are removed, others move towards the start of the list, so an agent is looked for
        // there first. An agent that is back before it is looked for was never missing.
        private function findIndex(listed:ListedAgents, row:int):int
        {
            var agent:Agent = listed.agentsByRow[row];
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
            return index;
        }
    }
}
