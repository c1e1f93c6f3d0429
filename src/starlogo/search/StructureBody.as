package starlogo.search
{
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
        private var _body:Body = new Body();

        // By the kind of structure: the shape, with the structure's middle moved to the origin.
        private var _shapes:Vector.<ModelShape> = new Vector.<ModelShape>(BoundingStructure.KIND_COUNT, true);

        // The middle and half of the lengths of the extents.
        private var _extents:Vector.<Number> = new Vector.<Number>(6, true);

        /**
         * Returns the body of a structure. The next call overwrites it.
         *
         * @param at where the structure is put into the world; null if it is in the world already
         * @throws ArgumentError if the structure is null, or not a sphere, box, capsule or hull
         * @throws RangeError if <code>at</code> is null and the structure is not in the world
         */
        public function setTo(structure:BoundingStructure, at:Placement = null):Body
        {
            ModelShape.requireStructure(structure);
            var shape:ModelShape = shapeOfKind(structure.kind);
            var inWorld:BoundingStructure = at == null ? structure : structure.place(at, shape.structure);
            inWorld.findPlacedBox(Placement.IDENTITY, _extents);
            if (at == null && !areExtentsInWorld)
            {
                // a number of either kind that is infinite or NaN makes such numbers of the other
                requireInWorld("a structure's middle and half of its length", _extents[0], _extents[1], _extents[2]);
                requireInWorld("a structure's middle and half of its length", _extents[3], _extents[4], _extents[5]);
            }
            // moves the structure from its place to the origin, and the body to that place
            var place:Placement = _body.placement;
            place.x = -_extents[0];
            place.y = -_extents[1];
            place.z = -_extents[2];
            shape.setStructure(inWorld.place(place, shape.structure));
            place.x = _extents[0];
            place.y = _extents[1];
            place.z = _extents[2];
            _body.takeShape(shape, _extents);
            return _body;
        }

        // Whether all numbers of the extents are in the world. It reads them itself, because V8 makes objects of Numbers that are passed.
        private function get areExtentsInWorld():Boolean
        {
            var most:Number = 0;
            for (var i:int = 0; i < 6; i++)
            {
                // a NaN stays
                most = Math.max(most, Math.abs(_extents[i]));
            }
            return most <= Placement.LARGEST_COORDINATE;
        }

        private function shapeOfKind(kind:int):ModelShape
        {
            if (_shapes[kind] == null)
            {
                _shapes[kind] = new ModelShape("structure", ModelShape.ONLY_VARIANT, 0);
                _shapes[kind].ignoresRotation = true;
            }
            return _shapes[kind];
        }
    }
}
