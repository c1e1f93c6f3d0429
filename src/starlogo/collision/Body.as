package starlogo.collision
{
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.bounding.Sphere;
    import starlogo.engine;
    import starlogo.hierarchy.Hierarchy;

    use namespace engine;

    /**
     * What a collider keeps of an agent from frame to frame: its world shape, computed when the agent has changed
     * (thesis §3.5), and its place in the bins. Plain fields, because the inner loops of a frame read them.
     */
    internal final class Body
    {
        // minX, maxX, minY, maxY, minZ, maxZ
        private static var sExtents:Vector.<Number> = new Vector.<Number>(6, true);

        /** Whose body it is. */
        public var agent:Agent;

        /** The agent's id: settles the order of two bodies. */
        public var serial:int;

        /** What the collider that made it gave it for a mark; to a collider whose mark is another it is void. */
        public var owner:Object;

        /** The agent's revision that the world shape belongs to. */
        public var revision:int = -1;

        /** The agent's form that the extents belong to. */
        public var form:int = -1;

        /** What stands for the model, in the model's space; null where the numbers below say it all. */
        public var structure:BoundingStructure;

        /** The same in the world. */
        public var world:BoundingStructure;

        /** The structure in the world if it is a box, else null: spares the costliest frequent test its casts. */
        public var worldBox:Box;

        /** A sphere around the structure that is tried first, in the model's space, or null. */
        public var outerSphere:Sphere;

        /** The same in the world. */
        public var worldOuterSphere:Sphere;

        /** The hierarchy of the model, or null where none is used. */
        public var hierarchy:Hierarchy;

        /** The structure around all of it in the world, where another structure stands for the model at times. */
        public var worldRoot:BoundingStructure;

        /** Whether the hierarchy decides, and not the structure. */
        public var isHierarchical:Boolean;

        /** The agent's own limit to the levels that are visited, or 0. */
        public var depth:int = 0;

        /** The middle of the world shape's extents. */
        public var x:Number;

        /** @copy #x */
        public var y:Number;

        /** @copy #x */
        public var z:Number;

        /** Half the extent along x; a sphere's radius. */
        public var halfX:Number;

        /** Half the extent along y. */
        public var halfY:Number;

        /** Half the extent along z. */
        public var halfZ:Number;

        /** Whether the world shape is the sphere in these numbers: spares the most common test a call. */
        public var isSphere:Boolean;

        /** The ground rectangle while the body is in the bins, padded: the least x. */
        public var left:Number;

        /** The largest x. */
        public var right:Number;

        /** The least y. */
        public var front:Number;

        /** The largest y. */
        public var back:Number;

        /** The level of the bins that the body is entered in. */
        public var level:BinLevel;

        /** Its entries in at most four bins, in a ring. */
        public var entry:BinEntry;

        /** The agent's index in this frame's list. */
        public var index:int;

        /** The agent's breed in this frame's interests. */
        public var breed:int;

        /** The frame that last counted it: finds an agent that is listed twice. */
        public var frame:int = 0;

        /**
         * @param agent whose body it is
         * @param owner the mark of the collider that makes it
         */
        public function Body(agent:Agent, owner:Object)
        {
            this.agent = agent;
            serial = agent.id;
            this.owner = owner;
            entry = BinEntry.ring(this, 4);
        }

        /**
         * Looks up the hierarchy of the agent's model.
         *
         * @throws ArgumentError if there is none
         */
        public function takeHierarchy(greatLand:GreatLand):void
        {
            if (!greatLand.hierarchies.has(agent.shape))
            {
                throw new ArgumentError(agent
                        + ": its model was added while loadHierarchies was off; set it, and add the model again");
            }
            hierarchy = greatLand.hierarchies.hierarchy(agent.shape);
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
