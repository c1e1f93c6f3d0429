package starlogo.hierarchy
{
    import starlogo.engine;
    import starlogo.geometry.Tolerances;
    import starlogo.geometry.VertexBounds;

    use namespace engine;

    /**
     * Makes the nodes of a hierarchy. Their boxes are slightly larger than the extents of their parts.
     *
     * @private
     */
    public final class NodeMaker
    {
        private var _hierarchy:Hierarchy;
        private var _radius:Number = 0;

        /**
         * @param hierarchy the hierarchy to which the nodes belong
         * @param extents of the whole model: minX, minY, minZ, maxX, maxY, maxZ
         * @throws ArgumentError if a coordinate is larger than 1e60
         */
        public function NodeMaker(hierarchy:Hierarchy, extents:Vector.<Number>)
        {
            _hierarchy = hierarchy;
            // How far the model extends from its origin. The rounding error is relative to it.
            for (var i:int = 0; i < 6; i++)
            {
                _radius = Math.max(_radius, Math.abs(extents[i]));
            }
            VertexBounds.requireWithin(_radius);
            _radius *= Math.sqrt(3);
        }

        /**
         * How much larger than its part a box is. With this margin, everything that touches the surface touches the boxes. Boxes are inside
         * of their parents' boxes in spite of rounding.
         */
        public function marginOf(level:int):Number
        {
            return _radius * (Tolerances.SURFACES + Tolerances.NESTING * Math.max(1, Tolerances.NESTED_LEVELS - level));
        }

        /**
         * Makes a leaf. <code>divide()</code> can give it children.
         *
         * @param level the root's level is 1
         * @param first index of its first item in the hierarchy's order
         * @param end index after its last item
         * @param extents contains the extents of its part: minX, minY, minZ, maxX, maxY, maxZ
         * @param at index at which they begin
         */
        public function make(level:int, first:int, end:int, extents:Vector.<Number>, at:int = 0):HierarchyNode
        {
            var node:HierarchyNode = new HierarchyNode();
            node.hierarchy = _hierarchy;
            node.level = level;
            node.first = first;
            node.end = end;
            var margin:Number = marginOf(level);
            var minX:Number = extents[at];
            var minY:Number = extents[int(at + 1)];
            var minZ:Number = extents[int(at + 2)];
            var halfX:Number = 0.5 * (extents[int(at + 3)] - minX);
            var halfY:Number = 0.5 * (extents[int(at + 4)] - minY);
            var halfZ:Number = 0.5 * (extents[int(at + 5)] - minZ);
            node.x = minX + halfX;
            node.y = minY + halfY;
            node.z = minZ + halfZ;
            node.setHalfExtents(halfX + margin, halfY + margin, halfZ + margin);
            return node;
        }

        /**
         * Gives a node two children.
         *
         * @param node must not have children yet
         * @param axis the axis along which it is split
         * @param low the child on the low side
         * @param high the child on the high side
         * @param stopDepth the largest depth limit at which a visit ends at the node
         */
        public function divide(node:HierarchyNode, axis:int, low:HierarchyNode, high:HierarchyNode, stopDepth:int):void
        {
            node.stopDepth = stopDepth;
            node.splitAxis = axis;
            node.low = low;
            node.high = high;
        }
    }
}
