package starlogo.queries
{
    import flash.geom.Vector3D;
    import starlogo.agents.Agent;

    /** How an agent stands after it has walked. */
    public final class Footing
    {
        /** Whether it stands on something that is not too steep. Otherwise it is in the air, or on a slope that is too steep. */
        public var stands:Boolean = false;

        /** The agent that it stands on. If it stands on the ground, this is the ground's agent. It is null if the agent does not stand. */
        public var on:Agent = null;

        /**
         * What stopped or turned it on its way: an agent that was in its way, or the ground's agent for what is too steep there. If it has met several, this
         * is the last. It is null if it met nothing, or stepped over what it met. A fall and a push do not count.
         */
        public var against:Agent = null;

        /** The normal of the surface that it stands on, a unit vector. If the agent does not stand, the normal points up. */
        public var normal:Vector3D = new Vector3D(0, 0, 1);

        /**
         * How far it has come on the ground plane, as a part of the way, from 0 to 1. A fall does not count. Rounding can make it a little less than 1
         * on a free way. So what stops the agent is told by a small part, such as less than a half, in two walks in turn.
         */
        public var part:Number = 1;

        /**
         * How far the walk has first pushed the agent out of what it overlapped, in patches. It is 0 if it overlapped nothing. The push does not
         * count in <code>part</code>.
         */
        public var pushed:Number = 0;

        /** An empty Footing. Pass it to <code>AgentQueries.walk()</code>, which fills it. */
        public function Footing()
        {
        }

        /** Its values, as text. */
        public function toString():String
        {
            return "footing " + (stands ? "on " + on + ", normal " + normal : "in the air") + (against ? ", against " + against : "") + ", part " + part + ", pushed "
                + pushed;
        }
    }
}
