package starlogo.search
{
    import starlogo.agents.Agent;
    import starlogo.bounding.BoundingStructure;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.geometry.requireInWorld;

    use namespace engine;

    /**
     * Makes the body of a structure that belongs to no model, for questions about structures and points.
     *
     * @private
     */
    public final class StructureBody
    {
        private static const UPRIGHT:Placement = new Placement();

        private var _body:Body = new Body();

        // By the kind of structure: the shape, and the structure where it was put into the world.
        private var _shapes:Vector.<ModelShape> = new Vector.<ModelShape>(BoundingStructure.KIND_COUNT, true);
        private var _placed:Vector.<BoundingStructure> = new Vector.<BoundingStructure>(BoundingStructure.KIND_COUNT, true);

        // The middle and half of the lengths of the extents.
        private var _extents:Vector.<Number> = new Vector.<Number>(6, true);

        /**
         * Returns the body of a structure. The next call overwrites it.
         *
         * @param at where the structure is put into the world; null if it is in the world already
         * @throws ArgumentError if the structure is null, or not a sphere, box, capsule or hull
         * @throws RangeError if <code>at</code> is null and the structure is not in the world
         */
        public function read(structure:BoundingStructure, at:Placement = null):Body
        {
            ModelShape.requireStructure(structure);
            var inWorld:BoundingStructure = structure;
            if (at != null)
            {
                inWorld = _placed[structure.kind] = structure.place(at, _placed[structure.kind]);
            }
            inWorld.boxAroundInto(UPRIGHT, _extents);
            if (at == null)
            {
                requireInWorld("half of a structure's length", _extents[3], _extents[4], _extents[5]);
                requireInWorld("a structure's middle", _extents[0], _extents[1], _extents[2]);
            }
            _body.takeShape(shapeOf(inWorld));
            _body.rank = _body.depthLimit = 0;
            _body.placement.x = _extents[0];
            _body.placement.y = _extents[1];
            _body.placement.z = _extents[2];
            _body.halfX = _extents[3];
            _body.halfY = _extents[4];
            _body.halfZ = _extents[5];
            return _body;
        }

        // A shape of a structure in the world, with its middle moved to the origin. The body's place is that of the middle.
        private function shapeOf(structure:BoundingStructure):ModelShape
        {
            var shape:ModelShape = _shapes[structure.kind];
            if (shape == null)
            {
                shape = _shapes[structure.kind] = new ModelShape("structure", Agent.ANY_KIND, 0);
                shape.isUpright = true;
            }
            var toOrigin:Placement = _body.placement;
            toOrigin.copyFrom(UPRIGHT);
            toOrigin.x = -_extents[0];
            toOrigin.y = -_extents[1];
            toOrigin.z = -_extents[2];
            shape.setStructure(structure.place(toOrigin, shape.structure));
            return shape;
        }
    }
}
