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
        /** For <code>world</code>: there is neither ground nor are there edges. Nothing writes to it. */
        public static const NO_WORLD:Vector.<WorldAgent> = new <WorldAgent>[null, null];

        /** The list of agents. */
        public var agents:Vector.<Agent> = null;

        /** By index in the list: whether the agent takes part; null for all. */
        public var takePart:Vector.<Boolean> = null;

        /** The pairs of breeds that count; null for all. It must not be null if there is an agent of the ground or of the edges. */
        public var interests:BreedInterests = null;

        /** The agents of the ground and of the edges of the world, by their rows; null where there is none. */
        public var world:Vector.<WorldAgent> = NO_WORLD;

        /** Sets all. */
        public function setTo(agents:Vector.<Agent>, takePart:Vector.<Boolean>, interests:BreedInterests, world:Vector.<WorldAgent>):void
        {
            this.agents = agents;
            this.takePart = takePart;
            this.interests = interests;
            this.world = world;
        }
    }
}
