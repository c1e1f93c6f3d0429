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

        /**
         * The number of the agent's triangle that is nearest to the point, if triangles decide. The model's first triangle is 0. It is -1 if what
         * is touched is a structure, the ground or an edge of the world.
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

        /** An empty hit. Pass it to <code>AgentQueries.castShape()</code>, which fills it. */
        public function ShapeHit()
        {
        }
    }
}
