package starlogo.handlers
{
    import starlogo.agents.Agent;
    import starlogo.search.IdTable;

    /**
     * Tells whether an agent is still in the list, which handlers may change. If an agent has left its index, the search begins towards the
     * start of the list, because agents move there when others are removed. Then it goes through the whole list. When the number of
     * searched entries has reached the length of the list, the indices of all agents are read again.
     *
     * @private
     */
    public final class AgentList
    {
        /** The number of entries of the list that were searched in this frame. */
        public var looked:int = 0;

        private var _agents:Vector.<Agent> = null;
        private var _isKnown:Boolean = false;
        private var _readAt:int;

        // The last known index of each agent, by its id. Missing agents are removed.
        private var _indices:IdTable = new IdTable();

        /** Creates an AgentList without a list. */
        public function AgentList()
        {
        }

        /** Sets the list of a frame. The first question reads the indices of its agents. */
        public function setAgents(agents:Vector.<Agent>):void
        {
            _agents = agents;
            _isKnown = false;
            looked = 0;
        }

        /** Lets go of the list. */
        public function end():void
        {
            _agents = null;
        }

        /** The last known index of an agent; -1 if it is missing. */
        public function indexOf(agent:Agent):int
        {
            if (!_isKnown)
            {
                _indices.clear();
                readIndices();
                _isKnown = true;
            }
            return _indices.valueOf(agent.id);
        }

        /** Whether an agent is in the list, and was at every question about it in this frame. */
        public function contains(agent:Agent):Boolean
        {
            var before:int = indexOf(agent);
            if (before < 0)
            {
                return false;
            }
            var index:int = _agents.lastIndexOf(agent, before);
            looked += before - index;
            if (index < 0)
            {
                index = _agents.indexOf(agent);
                if (index < 0)
                {
                    looked += _agents.length;
                    _indices.remove(agent.id);
                    return false;
                }
                looked += index;
            }
            if (index != before)
            {
                _indices.set (agent.id, index);
            }
            if (looked - _readAt >= _agents.length)
            {
                readIndices();
            }
            return true;
        }

        // Reads the indices of all agents, except those that were added after the first reading.
        private function readIndices():void
        {
            for (var i:int = 0; i < _agents.length; i++)
            {
                var agent:Agent = _agents[i];
                if (agent != null && (!_isKnown || _indices.valueOf(agent.id) >= 0))
                {
                    _indices.set (agent.id, i);
                }
            }
            looked += _agents.length;
            _readAt = looked;
        }
    }
}
