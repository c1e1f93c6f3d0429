package starlogo.agents
{
    import flash.errors.IllegalOperationError;

    /**
     * Decides which agents count. It is the abstract base class of AgentFilter. Write a subclass of your own to filter the agents of a
     * Collision.
     */
    public class AgentPredicate
    {
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
