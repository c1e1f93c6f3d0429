package starlogo.handlers
{
    import starlogo.agents.Agent;

    /**
     * Two agents that touch, with the frame in which the touch began.
     *
     * @private
     */
    public final class Touch
    {
        /** The agent that was first in the list when the touch began. */
        public var first:Agent;

        /** The second agent. */
        public var second:Agent;

        /** The number of the first agent's breed when the touch began. */
        public var firstBreed:int;

        /** The number of the second agent's breed when the touch began. */
        public var secondBreed:int;

        /** The tracker's frame in which the touch began. */
        public var firstFrame:int;

        /** How many touches began before it. */
        public var serial:Number;

        /** Its index in the TouchTable. */
        public var index:int;

        /** Whether handlers have been called for both agents, not only for the first. */
        public var isCalledForBoth:Boolean;
    }
}
