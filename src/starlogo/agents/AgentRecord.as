package starlogo.agents
{
    /**
     * What a user of agents keeps with one of them from frame to frame: a link of the agent's chain of records, one for each
     * user. Plain fields, because the loops over all agents read them; users that keep more extend it.
     *
     * @private
     */
    public class AgentRecord
    {
        /** Whose record it is. */
        public var agent:Agent;

        /** The user's. A record with another token is somebody else's, or void. */
        public var cacheToken:CacheToken;

        /** Where the agent was in the user's list when it looked last. */
        public var listIndex:int;

        /** The user's frame that last met the agent in its list. */
        public var frame:int = 0;

        /** What was found for the breed. */
        public var breedIndex:int;

        /** Who looked up the breed for this record last; null when the agent has changed it. */
        public var breedToken:Object = null;

        /** The next record of the agent, or null. */
        public var next:AgentRecord = null;

        /**
         * @param agent whose record it is
         * @param cacheToken the user's
         */
        public function AgentRecord(agent:Agent, cacheToken:CacheToken)
        {
            this.agent = agent;
            this.cacheToken = cacheToken;
        }
    }
}
