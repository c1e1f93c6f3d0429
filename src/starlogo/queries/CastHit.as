package starlogo.queries
{
    import flash.geom.Vector3D;
    import starlogo.agents.Agent;

    /** What a ray or a cast meets: the agent, the point, and the triangle there. The base class of RayHit and ShapeHit. */
    public class CastHit
    {
        /** The agent that is met. It is null only in an empty hit. */
        public var agent:Agent = null;

        /** The point in the world where it is met. If a ray's origin is inside the agent, it is the origin. */
        public var point:Vector3D = new Vector3D();

        /**
         * The direction out of the agent's surface at the point, in the world: a unit vector. If a ray's origin is inside the agent, it points
         * against the ray.
         */
        public var normal:Vector3D = new Vector3D();

        /**
         * The number of the triangle that a ray meets, or that is nearest to the point where a shape touches, if triangles decide. The model's
         * first triangle is 0. It is -1 if what is met is a structure, the ground or an edge of the world, or if a ray's origin is inside the agent.
         */
        public var triangle:int = -1;

        /**
         * The number of the mesh that the triangle belongs to: <code>Model.meshes</code>. It is -1 if triangle is -1, or if the model
         * does not say.
         */
        public var mesh:int = -1;

        /** The name of the mesh, or null. */
        public var meshName:String = null;

        /** The number of the triangle's material: <code>Model.materials</code>. It is -1 if triangle is -1, or if the model does not say. */
        public var material:int = -1;

        /** The name of the material, or null. */
        public var materialName:String = null;

        /**
         * The weights of the triangle's corners at the point (barycentric coordinates): x of the first, y of the second, z of the third, in the
         * order of <code>Model.triangles</code>. They add up to 1. All are 0 if triangle is -1.
         */
        public var weights:Vector3D = new Vector3D();

        /** An empty hit. Questions return a RayHit or a ShapeHit. */
        public function CastHit()
        {
        }
    }
}
