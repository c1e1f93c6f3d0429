package starlogo.collision
{
    import starlogo.agents.Agent;
    import starlogo.agents.AgentRecord;
    import starlogo.agents.CacheToken;

    /** What a Collision notes of an agent for a frame: where it is in the list, and its breed's number. */
    internal final class ListedAgent extends AgentRecord
    {
        /** The frame that the rest is of. */
        public var frame:int = 0;

        /** Where it was in the list when the frame's calls began. */
        public var order:int;

        /** Where it was when somebody looked last: a hint, since handlers change the list. */
        public var listIndex:int;

        /** Whether a handler has taken it out. */
        public var isGone:Boolean;

        /**
         * @param agent whose notes they are
         * @param cacheToken that of the Collision
         */
        public function ListedAgent(agent:Agent, cacheToken:CacheToken)
        {
            super(agent, cacheToken);
        }
    }
}
