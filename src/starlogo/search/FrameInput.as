package starlogo.search
{
    import starlogo.agents.Agent;

    /**
     * Among what a frame's pairs are to be found.
     *
     * @private
     */
    public final class FrameInput
    {
        /** The list of agents. */
        public var agents:Vector.<Agent> = null;

        /** By index in the list: whether the agent takes part; null for all. */
        public var takePart:Vector.<Boolean> = null;

        /** The pairs of breeds that count; null for all. It must not be null if there is an agent of the ground or of the edges. */
        public var interests:BreedInterests = null;

        /** The agent of the ground, or null. */
        public var ground:Agent = null;

        /** The agent of the edges of the world, or null. */
        public var edges:Agent = null;

        /** Sets all. */
        public function setTo(agents:Vector.<Agent>, takePart:Vector.<Boolean>, interests:BreedInterests, ground:Agent, edges:Agent):void
        {
            this.agents = agents;
            this.takePart = takePart;
            this.interests = interests;
            this.ground = ground;
            this.edges = edges;
        }
    }
}
