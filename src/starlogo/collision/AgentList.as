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

        /** Its length when the calls began; not 0. */
        public var lengthAtStart:int;

        /** Whether the agent that was not found last may be there all the same. */
        public var isInDoubt:Boolean = false;

        /** How many agents were looked at in this frame, to find others. */
        public var comparisons:Number = 0;

        /** Marks the notes of this list among the agents' records. */
        public var cacheToken:CacheToken = new CacheToken();

        /** Notes of another frame are void. */
        public var frame:int = 0;

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
            cacheToken.noteUse();
            frame++;
            comparisons = 0;
            lengthAtStart = agents.length;
            for (var i:int = 0; i < lengthAtStart; i++)
            {
                var agent:Agent = agents[i];
                if (agent == null)
                {
                    continue;
                }
                var record:AgentRecord = agent.records;
                if (record == null || record.cacheToken !== cacheToken)
                {
                    record = find(agent);
                }
                record.frame = frame;
                record.listIndex = i;
            }
        }

        /** Lets go of the list. */
        public function end():void
        {
            agents = null;
        }

        /**
         * The record of an agent in this frame. Its listIndex is where the agent was when the calls began: in any case less than
         * lengthAtStart.
         */
        public function recordOf(agent:Agent):AgentRecord
        {
            var record:AgentRecord = agent.records;
            if (record == null || record.cacheToken !== cacheToken)
            {
                record = find(agent);
            }
            if (record.frame != frame)
            {
                // it was not in the list; should it come into it, then most likely at the end
                record.frame = frame;
                record.listIndex = lengthAtStart - 1;
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
        public function contains(record:AgentRecord, calls:int):Boolean
        {
            var notes:ListRecord = record as ListRecord;
            isInDoubt = false;
            if (notes.goneIn == frame)
            {
                return false;
            }
            var index:int = notes.movedIn == frame ? notes.movedTo : notes.listIndex;
            if (index < agents.length)
            {
                if (agents[index] === notes.agent)
                {
                    return true;
                }
                noteWhoIsAt(index);
            }
            index = indexByOrder(notes);
            if (index < 0)
            {
                index = indexBySearch(notes, calls);
            }
            if (index >= 0)
            {
                notes.movedIn = frame;
                notes.movedTo = index;
                return true;
            }
            if (!isInDoubt)
            {
                notes.goneIn = frame;
            }
            return false;
        }

        private function find(agent:Agent):AgentRecord
        {
            var record:AgentRecord = agent.records;
            while (record != null && record.cacheToken !== cacheToken)
            {
                record = record.next;
            }
            if (record == null)
            {
                record = new ListRecord(agent, cacheToken);
                agent.addRecord(record);
            }
            return record;
        }

        private function noteWhoIsAt(index:int):void
        {
            var agent:Agent = agents[index];
            if (agent != null)
            {
                var notes:ListRecord = recordOf(agent) as ListRecord;
                notes.movedIn = frame;
                notes.movedTo = index;
            }
        }

        // By bisection: right for a list that kept its order, whoever was taken out or added at its end.
        private function indexByOrder(record:ListRecord):int
        {
            var order:int = record.listIndex;
            var low:int = 0;
            var high:int = agents.length - 1;
            while (low <= high)
            {
                var middle:int = (low + high) >> 1;
                var agent:Agent = agents[middle];
                comparisons++;
                if (agent === record.agent)
                {
                    return middle;
                }
                if (agent != null && recordOf(agent).listIndex < order)
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

        private function indexBySearch(record:ListRecord, calls:int):int
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
