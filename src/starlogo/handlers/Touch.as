package starlogo.handlers
{
    import starlogo.agents.Agent;

    /**
     * Two agents that touch, from the frame in which that began on.
     *
     * @private
     */
    public final class Touch
    {
        /** The agent that was first in the list when the touch began. */
        public var first:Agent;

        /** The other one. */
        public var second:Agent;

        /** The number of the breed that the first had when it began. */
        public var firstBreed:int;

        /** The number of the breed that the other one had then. */
        public var secondBreed:int;

        /** The tracker's frame in which the touch began. */
        public var beganIn:int;

        /** The last of the tracker's frames in which the two touched. */
        public var seenIn:int;

        /** Whether handlers have been called for both agents, not only for the first. */
        public var isBothWays:Boolean;

        /** Of no agents yet. */
        public function Touch()
        {
        }
    }
}
