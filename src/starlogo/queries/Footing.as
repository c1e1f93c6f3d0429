package starlogo.queries
{
    import flash.geom.Vector3D;
    import starlogo.agents.Agent;

    /** How an agent stands after it has walked. */
    public final class Footing
    {
        /** Whether it stands on something that is not too steep. Otherwise it is in the air, or on a slope that is too steep. */
        public var stands:Boolean = false;

        /** What it stands on: an agent, or the one that stands for the ground. Null if it does not stand. */
        public var on:Agent = null;

        /** The normal of what it stands on, of length 1; upright if it does not stand. */
        public var normal:Vector3D = new Vector3D(0, 0, 1);

        /** How far it has come on the ground plane, as a part of the way, from 0 to 1. */
        public var part:Number = 1;

        /** For AgentQueries to write into. */
        public function Footing()
        {
        }
    }
}
