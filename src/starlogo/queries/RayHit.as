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

        /**
         * The number of the mesh that the triangle belongs to: <code>Model.meshes</code>, and its name in <code>Model.meshNames</code>. It is -1
         * if triangle is -1, or if the model does not say.
         */
        public var mesh:int = -1;

        /** The number of the triangle's material: <code>Model.materials</code>. It is -1 if triangle is -1, or if the model does not say. */
        public var material:int = -1;

        /** The name of the material, or null. */
        public var materialName:String = null;

        /**
         * The weights of the triangle's corners at the point (barycentric coordinates): x of the first, y of the second, z of the third, in the
         * order of <code>Model.triangles</code>. They add up to 1. All are 0 if triangle is -1.
         */
        public var weights:Vector3D = new Vector3D();

        /** An empty hit. Pass it to <code>AgentQueries.cast()</code>, which fills it. */
        public function RayHit()
        {
        }
    }
}
