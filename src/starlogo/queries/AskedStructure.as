package starlogo.queries
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.geometry.Tolerances;
    import starlogo.intersection.intersects;
    import starlogo.search.AgentTable;
    import starlogo.search.ModelShape;
    import starlogo.search.TreePairs;
    import starlogo.solid.TreePair;

    use namespace engine;

    /**
     * A sphere, box or capsule in the world that a question is about: whether it touches rows of a table, as a collision system sees them.
     *
     * @private
     */
    public final class AskedStructure
    {
        /** The middle, then half the lengths along the axes. */
        public var extents:Vector.<Number> = new Vector.<Number>(6, true);

        // By kind: as wide as it is for touching; with its middle at the origin of a space that is placed where it is.
        private var _inWorld:Vector.<BoundingStructure> = new Vector.<BoundingStructure>(3);
        private var _centred:Vector.<BoundingStructure> = new Vector.<BoundingStructure>(3);
        private var _kind:int = 0;
        private var _placement:Placement = new Placement();

        private var _toWorld:Placement = new Placement();
        private var _toCentre:Placement = new Placement();
        private var _rowPlacement:Placement = new Placement();
        private var _pair:TreePair = new TreePair();

        /** Begins without a structure. */
        public function AskedStructure()
        {
        }

        /**
         * Sets the structure.
         *
         * @throws ArgumentError if it is null, or not a sphere, box or capsule
         * @throws RangeError if it is not finite
         */
        public function setTo(structure:BoundingStructure):void
        {
            if (structure == null || structure.kind > BoundingStructure.BOX)
            {
                throw new ArgumentError("a sphere, box or capsule is needed, not " + structure);
            }
            structure.turnedExtentsInto(_toWorld, extents);
            for (var i:int = 0; i < 6; i++)
            {
                if (!isFinite(extents[i]))
                {
                    throw new RangeError("a structure must be finite: " + structure);
                }
            }
            _kind = structure.kind;
            var x:Number = _placement.x = extents[0];
            var y:Number = _placement.y = extents[1];
            var z:Number = _placement.z = extents[2];
            _toCentre.x = -x;
            _toCentre.y = -y;
            _toCentre.z = -z;
            _centred[_kind] = structure.place(_toCentre, _centred[_kind]);
            _inWorld[_kind] = structure.place(_toWorld, _inWorld[_kind]);
            _inWorld[_kind].widen(Tolerances.PLACES * (Math.abs(x) + Math.abs(y) + Math.abs(z)));
        }

        /** Whether a row, whose model is not loading, touches the structure; in exact mode triangles decide. */
        public function touches(table:AgentTable, row:int, trees:TreePairs):Boolean
        {
            var shape:ModelShape = table.shapes[row];
            if (shape.hierarchy == null)
            {
                return intersects(table.structureOf(row), _inWorld[_kind]);
            }
            return _pair.areOverlapping(shape.hierarchy, table.placementOf(row, _rowPlacement), trees.depthOf(table, row), null, _centred[_kind], _placement, 1,
                    trees.exact);
        }
    }
}
