package starlogo.collision
{
    import starlogo.agents.Agent;
    import starlogo.agents.CacheToken;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.bounding.Capsule;
    import starlogo.bounding.Sphere;
    import starlogo.broadphase.AgentProxy;
    import starlogo.hierarchy.Hierarchy;

    /**
     * An agent as a collider sees it: its proxy in the broad phase, with what stands for its model, and that in the world,
     * computed when the agent has changed (thesis §3.5).
     */
    internal final class WorldShape extends AgentProxy
    {
        // minX, maxX, minY, maxY, minZ, maxZ
        private static var sExtents:Vector.<Number> = new Vector.<Number>(6, true);

        /** The name of the model that it is bound to; null for none. */
        public var model:String = null;

        /** The structure that stands for the model, in the model's space; null where none does. */
        public var structure:BoundingStructure = null;

        /** The same in the world. */
        public var worldStructure:BoundingStructure = null;

        /** The structure in the world if it is a box, else null: spares the costliest frequent test its casts. */
        public var worldBox:Box = null;

        /** A sphere around the structure that is tried first, in the model's space, or null. */
        public var outerSphere:Sphere = null;

        /** The same in the world. */
        public var worldOuterSphere:Sphere = null;

        /** A capsule around the structure that is tried first, in the model's space, or null. */
        public var outerCapsule:Capsule = null;

        /** The same in the world. */
        public var worldOuterCapsule:Capsule = null;

        /** The hierarchy of the model, or null where none is used. */
        public var hierarchy:Hierarchy = null;

        /** The structure around all of it in the world. */
        public var worldRoot:BoundingStructure = null;

        /** Whether the hierarchy decides, and not the structure. */
        public var isHierarchical:Boolean = false;

        /** The agent's own limit to the levels that are visited, or 0. */
        public var depth:int = 0;

        /**
         * @param agent whose world shape it is
         * @param cacheToken that of the collider
         */
        public function WorldShape(agent:Agent, cacheToken:CacheToken)
        {
            super(agent, cacheToken);
        }

        /** Forgets the model. */
        public function unbind():void
        {
            model = null;
            structure = worldStructure = null;
            worldBox = null;
            outerSphere = worldOuterSphere = null;
            outerCapsule = worldOuterCapsule = null;
            hierarchy = null;
            worldRoot = null;
            isHierarchical = isSphere = false;
            level = null;
            revision = extentsRevision = -1;
        }

        /** Takes over the extents of a structure in the world. */
        public function takeExtentsOf(structure:BoundingStructure):void
        {
            var extents:Vector.<Number> = sExtents;
            structure.extentsInto(extents);
            halfX = (extents[1] - extents[0]) / 2;
            halfY = (extents[3] - extents[2]) / 2;
            halfZ = (extents[5] - extents[4]) / 2;
            x = extents[0] + halfX;
            y = extents[2] + halfY;
            z = extents[4] + halfZ;
        }
    }
}
