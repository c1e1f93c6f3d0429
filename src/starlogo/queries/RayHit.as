package starlogo.queries
{
    import flash.geom.Vector3D;
    import starlogo.agents.Agent;

    /** The point where a ray first meets an agent, with the distance and the normal there. <code>AgentQueries.cast()</code> returns it. */
    public final class RayHit
    {
        /** The agent that the ray meets. */
        public var agent:Agent = null;

        /** The distance from the ray's origin to the point, in patches. It is 0 if the origin is inside the agent. */
        public var distance:Number = 0;

        /** The point in the world. If the ray's origin is inside the agent, it is the origin. */
        public var point:Vector3D = new Vector3D();

        /**
         * The direction out of the surface at the point, in the world: a unit vector. If the ray's origin is inside the agent, it points against
         * the ray.
         */
        public var normal:Vector3D = new Vector3D();

        /**
         * The number of the triangle that the ray meets, if triangles decide. The model's first triangle is 0. It is -1 if the ray meets a
         * structure, or if its origin is inside the agent.
         */
        public var triangle:int = -1;

        /** An empty hit. Pass it to <code>AgentQueries.cast()</code>, which fills it. */
        public function RayHit()
        {
        }
    }
}
