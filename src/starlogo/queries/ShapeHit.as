package starlogo.queries
{
    import flash.geom.Vector3D;
    import starlogo.agents.Agent;

    /** Where a structure, or an agent, that is cast along a way touches an agent. */
    public final class ShapeHit
    {
        /** The agent that it touches. */
        public var agent:Agent = null;

        /** The part of the way that is free, from 0 to 1; 0 if it touches the agent at the beginning and the way goes into it. */
        public var time:Number = 0;

        /** A point where the two touch then, in the world. */
        public var point:Vector3D = new Vector3D();

        /** Of length 1, from the agent to what is cast, in the world. */
        public var normal:Vector3D = new Vector3D();

        /** For AgentQueries to write into. */
        public function ShapeHit()
        {
        }
    }
}
