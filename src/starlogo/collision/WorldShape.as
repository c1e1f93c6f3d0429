package starlogo.collision
{
    import starlogo.agents.Agent;
    import starlogo.agents.CacheToken;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.broadphase.AgentProxy;
    import starlogo.hierarchy.Hierarchy;

    /**
     * An agent as a collider sees it: its proxy in the broad phase, with what stands for its model, and that in the world,
     * computed when the agent has changed (thesis §3.5).
     *
     * <p>Here and in its base classes fields that a frame reads together stand together: with thousands of agents, memory is what
     * takes time.</p>
     */
    internal final class WorldShape extends AgentProxy
    {
        // minX, maxX, minY, maxY, minZ, maxZ
        private static var sExtents:Vector.<Number> = new Vector.<Number>(6, true);

        /** The structure around all of the hierarchy, in the world. */
        public var worldRoot:BoundingStructure = null;

        /** The agent's own limit to the levels that are visited, or 0. */
        public var depth:int = 0;

        /** The hierarchy of the model, or null where none is used. */
        public var hierarchy:Hierarchy = null;

        /** Whether the hierarchy decides, and not the structure. */
        public var isHierarchical:Boolean = false;

        /** The structure that stands for the model, in the model's space; null where none does. */
        public var structure:BoundingStructure = null;

        /** The same in the world. */
        public var worldStructure:BoundingStructure = null;

        /** What is tried before the structure, or null. */
        public var outer:OuterStructures = null;

        /** The structure in the world if it is a box, else null: spares the costliest frequent test its casts. */
        public var worldBox:Box = null;

        /** The structure around all of the hierarchy, in the model's space. */
        public var root:BoundingStructure = null;

        /** The name of the model that it is bound to; null for none. */
        public var model:String = null;

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
            outer = null;
            hierarchy = null;
            root = worldRoot = null;
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
