package starlogo.agents
{
    import flash.errors.IllegalOperationError;
    import starlogo.engine;

    use namespace engine;

    /**
     * Decides which agents count. It is the abstract base class of AgentFilter. Write a subclass of your own to filter the agents of a
     * Collision.
     */
    public class AgentPredicate
    {
        /** @private Called before agents are asked about. It warns of names that are probably misspelled, because these agents have others. */
        engine function checkNames(agents:Vector.<Agent>):void
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
