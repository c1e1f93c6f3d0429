package starlogo.search
{
    import starlogo.agents.Agent;
    import starlogo.agents.AgentPredicate;
    import starlogo.agents.copyAgents;
    import starlogo.engine;

    use namespace engine;

    /**
     * The input of a frame's search: the list of agents, which of them take part, which breeds count, the ground and the edges of the world.
     *
     * @private
     */
    public final class FrameInput
    {
        /** The list of agents. If there is a filter it is a copy, because a filter may change the game's list. */
        public var agents:Vector.<Agent> = null;

        /** By index in the list: whether the filter admits the agent; null without a filter. */
        public var admitted:Vector.<Boolean> = null;

        /** The pairs of breeds that count; null for all. It must not be null if there is ground or there are edges. */
        public var interests:BreedInterests = null;

        /** The ground, or null. */
        public var ground:WorldAgent = null;

        /** The edges of the world, or null. */
        public var edges:WorldAgent = null;

        // What a filter fills: the copy of the list, and its answers.
        private var _copy:Vector.<Agent> = new Vector.<Agent>();
        private var _answers:Vector.<Boolean> = new Vector.<Boolean>();

        /** Sets all. All agents take part. */
        public function setTo(agents:Vector.<Agent>, interests:BreedInterests, ground:WorldAgent, edges:WorldAgent):void
        {
            this.agents = agents;
            this.interests = interests;
            this.ground = ground;
            this.edges = edges;
            admitted = null;
        }

        /** Asks a filter of the game's which agents take part. An entry that is null does, because the collision system refuses it. */
        public function askFilter(filter:AgentPredicate):void
        {
            agents = copyAgents(agents, _copy);
            admitted = _answers;
            filter.checkNames(agents);
            for (var i:int = 0; i < agents.length; i++)
            {
                admitted[i] = agents[i] == null || filter.admits(agents[i]);
            }
        }
    }
}
