package starlogo.queries
{
    import flash.geom.Vector3D;
    import starlogo.agents.Agent;

    /** Where a ray meets an agent. */
    public final class RayHit
    {
        /** The agent that it meets. */
        public var agent:Agent = null;

        /** How far that is from the ray's origin; 0 if the origin is inside of the agent. */
        public var distance:Number = 0;

        /** Where the ray meets it, in the world. */
        public var point:Vector3D = new Vector3D();

        /** Of length 1, out of the surface that it meets, in the world; against the ray if the origin is inside of the agent. */
        public var normal:Vector3D = new Vector3D();

        /**
         * The number of the triangle that the ray meets, where triangles decide; the model's first is 0. -1 if it meets a structure, or if its origin is inside
         * of the agent.
         */
        public var triangle:int = -1;

        /** For AgentQueries to write into. */
        public function RayHit()
        {
        }
    }
}
