package starlogo.agents
{
    import flash.errors.IllegalOperationError;

    /**
     * Says which agents count: what AgentFilter is to the parts of the engine that know nothing of questions. Abstract; a subclass of a client's own may be the
     * filter of a Collision.
     */
    public class AgentPredicate
    {
        /** For subclasses only. */
        public function AgentPredicate()
        {
        }

        /**
         * Whether an agent counts.
         *
         * @param agent not null
         */
        public function admits(agent:Agent):Boolean
        {
            throw new IllegalOperationError(this + " does not implement admits");
        }
    }
}
