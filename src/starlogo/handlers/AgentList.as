package starlogo.handlers
{
    import starlogo.agents.Agent;
    import starlogo.search.IdTable;

    /**
     * Tells whether an agent still is in the list that handlers change. An agent that is not in its place is looked for by bisection, which finds
     * it if the list has kept its order, and else in the whole list; when these searches have cost as much as a look at every agent, the places of
     * all are read again.
     *
     * @private
     */
    public final class AgentList
    {
        // The costs of a bisection and of a search of the whole list, as numbers of agents that are looked at.
        private static const BISECTION:int = 8;
        private static const SEARCH:int = 512;

        private var _agents:Vector.<Agent> = null;
        private var _isKnown:Boolean = false;
        private var _cost:int;

        // By the agents' ids: their places when these were last read; agents that have been found missing are taken out.
        private var _places:IdTable = new IdTable();

        /** No list yet. */
        public function AgentList()
        {
        }

        /** Sets the list of a frame; its places are read when the first question is asked. */
        public function setAgents(agents:Vector.<Agent>):void
        {
            _agents = agents;
            _isKnown = false;
        }

        /** Lets go of the list. */
        public function end():void
        {
            _agents = null;
        }

        /** The place of an agent when the places were last read; -1 if it has been found missing. */
        public function placeOf(agent:Agent):int
        {
            if (!_isKnown)
            {
                _places.clear();
                readPlaces();
                _isKnown = true;
            }
            return _places.valueOf(agent.id);
        }

        /** Whether an agent is in the list, and was at every question about it in this frame. */
        public function contains(agent:Agent):Boolean
        {
            var place:int = placeOf(agent);
            if (place < 0)
            {
                return false;
            }
            if (place < _agents.length && _agents[place] === agent)
            {
                return true;
            }
            _cost += BISECTION;
            if (!isInOrder(agent, place))
            {
                if (_agents.indexOf(agent) < 0)
                {
                    _places.remove(agent.id);
                    return false;
                }
                _cost += SEARCH;
            }
            if (_cost >= _agents.length)
            {
                readPlaces();
            }
            return true;
        }

        // Reads the places of all agents, except those that were added after the first reading.
        private function readPlaces():void
        {
            _cost = 0;
            for (var i:int = 0; i < _agents.length; i++)
            {
                var agent:Agent = _agents[i];
                if (agent != null && (!_isKnown || _places.valueOf(agent.id) >= 0))
                {
                    _places.set (agent.id, i);
                }
            }
        }

        // Whether bisection finds an agent: right for a list that kept its order, whichever were taken out or added at its end.
        private function isInOrder(agent:Agent, place:int):Boolean
        {
            var low:int = 0;
            var high:int = _agents.length - 1;
            while (low <= high)
            {
                var middle:int = (low + high) >> 1;
                var other:Agent = _agents[middle];
                if (other === agent)
                {
                    return true;
                }
                var otherPlace:int = other == null ? -1 : _places.valueOf(other.id);
                if (otherPlace >= 0 && otherPlace < place)
                {
                    low = middle + 1;
                }
                else
                {
                    high = middle - 1;
                }
            }
            return false;
        }
    }
}
