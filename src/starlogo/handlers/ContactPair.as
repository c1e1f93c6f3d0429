package starlogo.handlers
{
    import starlogo.agents.Agent;

    /**
     * Two agents that touch, from the frame in which that began on.
     *
     * @private
     */
    public final class ContactPair
    {
        /** The agent that was first in the list when it began. */
        public var first:Agent;

        /** The other one. */
        public var second:Agent;

        /** The breed that the first had when it began. */
        public var firstBreed:String;

        /** The breed of the other one then. */
        public var secondBreed:String;

        /** The tracker's frame in which it began. */
        public var beganIn:int;

        /** The tracker's frame in which it was seen last. */
        public var seenIn:int;

        /** Whether the turn of the handlers that have the second for their collider has come; that of the first's has. */
        public var isBothWays:Boolean;

        /** Of no agents yet. */
        public function ContactPair()
        {
        }
    }
}
