package starlogo.search
{
    import starlogo.agents.Agent;
    import starlogo.bounding.BoundingStructure;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.geometry.requireInWorld;

    use namespace engine;

    /**
     * A sphere, box or capsule in the world that a question is about. It has a row of a table for a while, so other rows touch it as they
     * touch an agent's structure, and in exact mode their triangles decide.
     *
     * @private
     */
    public final class AskedStructure
    {
        // The agent that stands for the structure, at its middle.
        private var _agent:Agent = new Agent("structure");

        // By kind: the structure as a shape, with its middle at the origin.
        private var _shapes:Vector.<ModelShape> = new Vector.<ModelShape>(3, true);

        // The middle, then half the lengths along the axes.
        private var _extents:Vector.<Number> = new Vector.<Number>(6, true);
        private var _placement:Placement = new Placement();

        /** Begins without a structure. */
        public function AskedStructure()
        {
            _agent.giveIdBack();
        }

        /**
         * Puts a structure into the row of a table's first guest.
         *
         * @return the row
         * @throws ArgumentError if it is null, or not a sphere, box or capsule
         * @throws RangeError if it is not in the world
         */
        public function readInto(table:AgentTable, structure:BoundingStructure):int
        {
            require(structure);
            _placement.x = _placement.y = _placement.z = 0;
            structure.turnedExtentsInto(_placement, _extents);
            requireInWorld("half of a structure's length", _extents[3], _extents[4], _extents[5]);
            requireInWorld("a structure's middle", _extents[0], _extents[1], _extents[2]);
            _placement.x = -_extents[0];
            _placement.y = -_extents[1];
            _placement.z = -_extents[2];
            var shape:ModelShape = _shapes[structure.kind] ||= newShape();
            shape.setStructure(structure.place(_placement, shape.structure));
            _agent.placement.x = _extents[0];
            _agent.placement.y = _extents[1];
            _agent.placement.z = _extents[2];
            _agent.revision++;
            table.readGuest(0, _agent, shape);
            return 0;
        }

        /** Throws an ArgumentError if a structure is null, or not a sphere, box or capsule. */
        public static function require(structure:BoundingStructure):void
        {
            if (structure == null || structure.kind > BoundingStructure.BOX)
            {
                throw new ArgumentError("a sphere, box or capsule is needed, not " + structure);
            }
        }

        private static function newShape():ModelShape
        {
            var shape:ModelShape = new ModelShape("structure", Agent.ANY_KIND, 0);
            shape.isUpright = shape.meetsTriangles = true;
            return shape;
        }
    }
}
