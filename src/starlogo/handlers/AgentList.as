package starlogo.handlers
{
    import starlogo.agents.Agent;
    import starlogo.search.IdTable;

    /**
     * Tells whether an agent still is in the list that handlers change, in a time that does not grow with the list: 10,000 agents
     * of which 1,000 are taken out one by one must not take 1,000 looks at all.
     *
     * <p>It is for agents that are not where they were. In a list that kept its order they are found by bisection; an agent that was met
     * in the place of another is noted, which finds the one that a swap with the last moved. For what is not found so the whole list is
     * looked at anew, as long as that costs less than the frame itself does. Beyond that an agent is in doubt, and the question is to be
     * asked again after the next look.</p>
     *
     * @private
     */
    public final class AgentList
    {
        // How many agents may be looked at: so many, and some for each agent of the list and each question.
        private static const FREE:int = 4000;
        private static const LOOKS:int = 4;

        /** Whether the agent that was not found last may be there all the same. */
        public var isInDoubt:Boolean = false;

        /** How many agents may still be looked at. */
        public var credit:Number = 0;

        private var _agents:Vector.<Agent> = null;
        private var _isKnown:Boolean = false;

        // By the agents' ids: where each was at the last look and at the one before, and where it was found since.
        private var _order:IdTable = new IdTable();
        private var _orderBefore:IdTable = new IdTable();
        private var _places:IdTable = new IdTable();

        /** No list yet. */
        public function AgentList()
        {
        }

        /** Begins a frame's questions about a list, which is looked at with the first. */
        public function begin(agents:Vector.<Agent>):void
        {
            _agents = agents;
            _isKnown = false;
        }

        /** Lets go of the list. */
        public function end():void
        {
            _agents = null;
        }

        /** Looks where every agent is now. One that was not there at the look before stays gone. */
        public function look():void
        {
            var before:IdTable = _order;
            var order:IdTable = _orderBefore;
            _order = order;
            _orderBefore = before;
            order.clear();
            _places.clear();
            for (var i:int = 0; i < _agents.length; i++)
            {
                var agent:Agent = _agents[i];
                if (agent != null)
                {
                    if (!_isKnown || before.valueOf(agent.id) >= 0)
                    {
                        order.set (agent.id, i);
                    }
                }
            }
        }

        /** Where an agent was at the last look; -1 if it is gone. */
        public function placeOf(agent:Agent):int
        {
            if (!_isKnown)
            {
                look();
                _isKnown = true;
                credit = FREE + LOOKS * _agents.length;
            }
            return _order.valueOf(agent.id);
        }

        /**
         * Whether an agent is in the list, and was at every look.
         *
         * @return false for one that is in doubt, too
         */
        public function contains(agent:Agent):Boolean
        {
            isInDoubt = false;
            var order:int = placeOf(agent);
            if (order < 0)
            {
                return false;
            }
            credit += LOOKS;
            if (isNear(agent, order))
            {
                return true;
            }
            isInDoubt = credit < _agents.length;
            if (isInDoubt)
            {
                return false;
            }
            credit -= _agents.length;
            look();
            return placeOf(agent) >= 0;
        }

        // Whether an agent is where it was, or where that has moved to.
        private function isNear(agent:Agent, order:int):Boolean
        {
            var expected:int = _places.valueOf(agent.id);
            if (expected < 0)
            {
                expected = order;
            }
            if (expected < _agents.length)
            {
                var other:Agent = _agents[expected];
                if (other === agent)
                {
                    return true;
                }
                if (other != null)
                {
                    _places.set (other.id, expected);
                }
            }
            // by bisection: right for a list that kept its order, whichever were taken out or added at its end
            var low:int = 0;
            var high:int = _agents.length - 1;
            while (low <= high)
            {
                var middle:int = (low + high) >> 1;
                other = _agents[middle];
                if (other === agent)
                {
                    _places.set (agent.id, middle);
                    return true;
                }
                var otherOrder:int = other == null ? -1 : _order.valueOf(other.id);
                if (otherOrder >= 0 && otherOrder < order)
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
