package starlogo.hierarchy
{
    import starlogo.engine;

    use namespace engine;

    /**
     * Divides the items of a node between two others (thesis §4.4).
     *
     * <p>An item goes to the side of the split that the centre of its extents is on. The thesis's splitting point, halfway along the
     * longest axis of the box or at the mean, may leave all triangles on one side; then it is halfway along the axis on which their
     * centres spread most. A node whose items all have the same centre is a leaf.</p>
     *
     * <p>On minVerticesToSplit the thesis says two things: in §4.4 it is the number of vertices up to which a node is not split
     * any further, in §4.8 the smallest number that is split. They differ for a node of just as many; here it is a leaf, as in
     * §4.4, which describes the algorithm, while §4.8 lists its parameters.</p>
     */
    internal final class NodeDivider
    {
        private var _hierarchy:Hierarchy;
        private var _items:Items;
        private var _maker:NodeMaker;
        private var _minVerticesToSplit:int;
        private var _splitByMean:Boolean;

        /**
         * @param hierarchy what the nodes are of
         * @param items what is divided
         * @param maker makes the nodes
         * @param minVerticesToSplit a node of no more vertices is a leaf
         * @param splitByMean whether to split at the mean
         */
        public function NodeDivider(hierarchy:Hierarchy, items:Items, maker:NodeMaker, minVerticesToSplit:int, splitByMean:Boolean)
        {
            _hierarchy = hierarchy;
            _items = items;
            _maker = maker;
            _minVerticesToSplit = minVerticesToSplit;
            _splitByMean = splitByMean;
        }

        /** Gives a node children, unless it has too few vertices, or its items are all in one place; returns whether it has. */
        public function divide(node:HierarchyNode):Boolean
        {
            if (!hasEnough(node))
            {
                return false;
            }
            var axis:int = node.longestAxis();
            var split:Number;
            if (_splitByMean)
            {
                split = _items.meanOf(node.first, node.end, axis);
            }
            else
            {
                split = 2 * (axis == 0 ? node.x : (axis == 1 ? node.y : node.z));
            }
            return divideAt(node, axis, split) || divideWhereCentresSpread(node);
        }

        private function hasEnough(node:HierarchyNode):Boolean
        {
            var count:int = node.end - node.first;
            if (!_hierarchy.hasTriangles || count == 1)
            {
                return !_hierarchy.hasTriangles && count > _minVerticesToSplit;
            }
            // so many different triangles have more vertices in any case
            var few:int = _minVerticesToSplit;
            return count > few * (few - 1) * (few - 2) / 6 || node.vertexCount > few;
        }

        private function divideWhereCentresSpread(node:HierarchyNode):Boolean
        {
            var widest:int = 0;
            var width:Number = 0;
            var split:Number = 0;
            for (var axis:int = 0; axis < 3; axis++)
            {
                var ends:Vector.<Number> = _items.centresOf(node.first, node.end, axis);
                if (ends[1] - ends[0] > width)
                {
                    widest = axis;
                    width = ends[1] - ends[0];
                    split = ends[0] + 0.5 * width;
                }
            }
            return width > 0 && divideAt(node, widest, split);
        }

        // Whether there are items on either side; if not, the node has no children.
        private function divideAt(node:HierarchyNode, axis:int, split:Number):Boolean
        {
            var middle:int = _items.divide(node.first, node.end, axis, split);
            if (middle == node.first || middle == node.end)
            {
                return false;
            }
            _maker.divide(node, axis, _maker.make(node.level + 1, node.first, middle, _items.leftExtents),
                    _maker.make(node.level + 1, middle, node.end, _items.rightExtents));
            return true;
        }
    }
}
