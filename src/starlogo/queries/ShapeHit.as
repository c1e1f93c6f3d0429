package starlogo.queries
{
    import flash.geom.Vector3D;
    import starlogo.agents.Agent;

    /**
     * The place where a cast first touches an agent. A cast moves a structure or an agent along a straight way.
     * <code>AgentQueries.castShape()</code> returns a ShapeHit.
     */
    public final class ShapeHit
    {
        /** The agent that is touched. */
        public var agent:Agent = null;

        /** The free part of the way, from 0 to 1. It is 0 if the two touch at the beginning and the way goes into the agent. */
        public var time:Number = 0;

        /** A point where the two touch at that time, in the world. */
        public var point:Vector3D = new Vector3D();

        /** The direction from the agent to the structure or agent that is cast, in the world: a unit vector. */
        public var normal:Vector3D = new Vector3D();

        /** An empty hit. Pass it to <code>AgentQueries.castShape()</code>, which fills it. */
        public function ShapeHit()
        {
        }
    }
}
