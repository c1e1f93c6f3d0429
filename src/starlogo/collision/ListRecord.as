package starlogo.collision
{
    import starlogo.agents.Agent;
    import starlogo.agents.AgentRecord;
    import starlogo.agents.CacheToken;

    /** What an AgentList keeps of an agent that is not where it was. */
    internal final class ListRecord extends AgentRecord
    {
        /** The frame that it has moved in. */
        public var movedIn:int = 0;

        /** Where it was found then: a hint, since handlers change the list. */
        public var movedTo:int;

        /** The frame that it was taken out of the list in. */
        public var goneIn:int = 0;

        /**
         * @param agent whose record it is
         * @param cacheToken that of the list
         */
        public function ListRecord(agent:Agent, cacheToken:CacheToken)
        {
            super(agent, cacheToken);
        }
    }
}
