package starlogo.collision
{
    import flash.geom.Vector3D;
    import starlogo.agents.Agent;
    import starlogo.agents.CacheToken;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.broadphase.AgentProxy;
    import starlogo.engine;
    import starlogo.hierarchy.Hierarchy;

    use namespace engine;

    /**
     * An agent as a collider sees it: its proxy in the broad phase, with what stands for its model, and that in the world,
     * computed when the agent has changed (thesis §3.5).
     *
     * <p>Here and in its base classes fields that a frame reads together stand together: with thousands of agents, memory is what
     * takes time.</p>
     */
    internal final class WorldShape extends AgentProxy
    {
        // the middle, then half the lengths
        private static var sExtents:Vector.<Number> = new Vector.<Number>(6, true);

        /**
         * The structure in the world if it is a box that decides alone, else null: spares the costliest frequent test its casts.
         * Like worldStructure, whose it is, to be had in the right place from <code>placeStructure()</code>.
         */
        public var box:Box = null;

        /** The revision for which the structure was placed last. */
        public var placedRevision:int = -1;

        /** The extentsRevision for which it was placed. */
        public var placedExtentsRevision:int = -1;

        /** The agent's own limit to the levels that are visited, or 0. */
        public var depth:int = 0;

        /** The hierarchy of the model, or null where none is used. */
        public var hierarchy:Hierarchy = null;

        /** Whether the hierarchy decides, and not the structure. */
        public var isHierarchical:Boolean = false;

        /** The structure that stands for the model, in the model's space; null where none does. */
        public var structure:BoundingStructure = null;

        /** The kind that was asked for, or Agent.ANY_KIND. */
        public var structureKind:int = -1;

        /** The same in the world, if <code>placeStructure()</code> was called since the shape was updated. */
        public var worldStructure:BoundingStructure = null;

        /** What is tried before the structure, or null. */
        public var outer:OuterStructures = null;

        /** The structure around all of the hierarchy, in the model's space. */
        public var root:BoundingStructure = null;

        /** The shape on its way; null until a search sweeps. */
        public var motion:MovingProxy = null;

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
            box = null;
            outer = null;
            hierarchy = null;
            root = null;
            isHierarchical = isSphere = false;
            level = null;
            revision = extentsRevision = placedRevision = placedExtentsRevision = -1;
        }

        /** Takes over the extents of a structure of the model, for the agent's size and turn. */
        public function takeExtentsOf(structure:BoundingStructure):void
        {
            var extents:Vector.<Number> = sExtents;
            structure.turnedExtentsInto(placement, extents);
            offsetX = extents[0];
            offsetY = extents[1];
            offsetZ = extents[2];
            halfX = extents[3];
            halfY = extents[4];
            halfZ = extents[5];
        }

        /**
         * Puts the structure, and what is tried before it, where the agent is. Not before a test asks for it: of thousands of
         * agents few have anybody near them.
         */
        public function placeStructure():void
        {
            if (box != null && placedExtentsRevision == extentsRevision)
            {
                // it has only moved, and its middle is that of the extents
                var middle:Vector3D = box.center;
                middle.x = x;
                middle.y = y;
                middle.z = z;
            }
            else
            {
                structure.place(placement, worldStructure);
                if (outer != null)
                {
                    outer.place(placement);
                }
                placedExtentsRevision = extentsRevision;
            }
            placedRevision = revision;
        }
    }
}
