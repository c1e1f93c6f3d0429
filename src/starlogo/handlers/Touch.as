package starlogo.handlers
{
    import starlogo.agents.Agent;

    /**
     * Two agents that touch, with the breeds that they had when the touch began.
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

        /** How many touches began before it. */
        public var order:Number;

        /** Its index in the TouchTracker. */
        public var index:int;

        /**
         * Whether the calls of its first frame have come to the second agent's handlers, or there are none. Otherwise it is a touch of the first agent
         * only, and ends in the next frame.
         */
        public var hasReachedSecond:Boolean;
    }
}
