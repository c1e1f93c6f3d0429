package starlogo.collision
{
    import starlogo.agents.Agent;
    import starlogo.agents.AgentRecord;
    import starlogo.agents.CacheToken;
    import starlogo.engine;

    use namespace engine;

    /**
     * Tells whether an agent still is in the list that handlers change, in a time that does not grow with the list: 10,000 agents
     * of which 1,000 are taken out one by one must not take 1,000 searches through all.
     *
     * <p>An agent mostly is where it was. In a list that kept its order it is found by bisection; who has taken the place of
     * another is noted, which finds the one that a swap with the last moved. What is not found so is searched for in the whole
     * list, as long as such searches cost less than the frame itself does. Beyond that an agent is in doubt, and whoever asks is to
     * come back when the whole list has been looked at anew.</p>
     */
    internal final class AgentList
    {
        // How many comparisons the searches may take for each agent and call: about as long as these take themselves.
        private static const COMPARISONS:int = 32;

        /** The list. */
        public var agents:Vector.<Agent> = null;

        /** Its length when the calls began; every hint is less. Not 0. */
        public var lengthAtStart:int;

        /** Whether the agent that was not found last may be there all the same. */
        public var isInDoubt:Boolean = false;

        /** How many agents were looked at in this frame, to find others. */
        public var comparisons:Number = 0;

        private var _cacheToken:CacheToken = new CacheToken();
        private var _frame:int = 0;

        /** No list yet. */
        public function AgentList()
        {
        }

        /**
         * Notes where every agent is.
         *
         * @param agents one at least
         */
        public function begin(agents:Vector.<Agent>):void
        {
            this.agents = agents;
            _cacheToken.noteUse();
            _frame++;
            comparisons = 0;
            lengthAtStart = agents.length;
            for (var i:int = 0; i < lengthAtStart; i++)
            {
                var agent:Agent = agents[i];
                if (agent == null)
                {
                    continue;
                }
                var link:AgentRecord = agent.records;
                if (link == null || link.cacheToken !== _cacheToken)
                {
                    link = find(agent);
                }
                var record:ListedAgent = link as ListedAgent;
                record.frame = _frame;
                record.order = i;
                record.listIndex = i;
                record.isGone = false;
            }
        }

        /** Lets go of the list. */
        public function end():void
        {
            agents = null;
        }

        /** The notes of an agent. */
        public function recordOf(agent:Agent):ListedAgent
        {
            var link:AgentRecord = agent.records;
            if (link == null || link.cacheToken !== _cacheToken)
            {
                link = find(agent);
            }
            var record:ListedAgent = link as ListedAgent;
            if (record.frame != _frame)
            {
                // it was not in the list, but may come into it
                record.frame = _frame;
                record.order = int.MAX_VALUE;
                record.listIndex = 0;
                record.isGone = false;
            }
            return record;
        }

        /**
         * Whether an agent is in the list.
         *
         * @param record of this frame
         * @param calls how many handlers were called in this frame
         * @return false for one that is in doubt, too
         */
        public function contains(record:ListedAgent, calls:int):Boolean
        {
            isInDoubt = false;
            if (record.isGone)
            {
                return false;
            }
            var index:int = record.listIndex;
            if (index < agents.length)
            {
                if (agents[index] === record.agent)
                {
                    return true;
                }
                noteWhoIsAt(index);
            }
            index = indexByOrder(record);
            if (index < 0)
            {
                index = indexBySearch(record, calls);
            }
            if (index >= 0)
            {
                record.listIndex = index < lengthAtStart ? index : 0;
                return true;
            }
            record.isGone = !isInDoubt;
            return false;
        }

        private function find(agent:Agent):AgentRecord
        {
            var link:AgentRecord = agent.records;
            while (link != null && link.cacheToken !== _cacheToken)
            {
                link = link.next;
            }
            if (link == null)
            {
                link = new ListedAgent(agent, _cacheToken);
                agent.addRecord(link);
            }
            return link;
        }

        private function noteWhoIsAt(index:int):void
        {
            var agent:Agent = agents[index];
            if (agent != null)
            {
                recordOf(agent).listIndex = index;
            }
        }

        // By bisection: right for a list that kept its order, whoever was taken out or added at its end.
        private function indexByOrder(record:ListedAgent):int
        {
            var order:int = record.order;
            var low:int = 0;
            var high:int = Math.min(order, agents.length - 1);
            while (low <= high)
            {
                var middle:int = (low + high) >> 1;
                var agent:Agent = agents[middle];
                comparisons++;
                if (agent === record.agent)
                {
                    return middle;
                }
                if (agent != null && recordOf(agent).order < order)
                {
                    low = middle + 1;
                }
                else
                {
                    high = middle - 1;
                }
            }
            return -1;
        }

        private function indexBySearch(record:ListedAgent, calls:int):int
        {
            var allowed:Number = COMPARISONS * (Number(lengthAtStart) + calls);
            isInDoubt = comparisons + agents.length > allowed;
            if (isInDoubt)
            {
                return -1;
            }
            comparisons += agents.length;
            return agents.indexOf(record.agent);
        }
    }
}
