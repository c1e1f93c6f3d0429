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

        // the node under way, what its items' coordinates add up to so far, and the item that comes next
        private var _node:HierarchyNode;
        private var _axis:int;
        private var _isAveraging:Boolean;
        private var _sum:Number;
        private var _next:int;

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

        /** Begins to give a node children; returns whether there is more to do. If not, it has too few vertices. */
        public function beginNode(node:HierarchyNode):Boolean
        {
            if (!hasEnough(node))
            {
                return false;
            }
            _node = node;
            _axis = node.longestAxis();
            _isAveraging = _splitByMean;
            if (_isAveraging)
            {
                _sum = 0;
                _next = node.first;
                return true;
            }
            var centre:Number = _axis == 0 ? node.x : (_axis == 1 ? node.y : node.z);
            _items.beginDivision(node.first, node.end, _axis, 2 * centre);
            return true;
        }

        /**
         * Goes on with the node that was begun. If its items are all in one place, it gets no children.
         *
         * @param most about how many items to look at
         * @return whether there is more to do
         */
        public function advance(most:int):Boolean
        {
            if (_isAveraging)
            {
                averageSome(most);
                return true;
            }
            if (_items.divideSome(most))
            {
                return true;
            }
            if (!applyDivision())
            {
                divideWhereCentresSpread();
            }
            return false;
        }

        private function averageSome(most:int):void
        {
            var end:int = Math.min(_next + most, _node.end);
            _sum = _items.sumOf(_sum, _next, end, _axis);
            _next = end;
            if (end == _node.end)
            {
                _isAveraging = false;
                _items.beginDivision(_node.first, end, _axis, _sum / (end - _node.first));
            }
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

        private function divideWhereCentresSpread():void
        {
            if (_items.beginWhereCentresSpread(_node.first, _node.end))
            {
                _items.divideSome(_node.end - _node.first);
                applyDivision();
            }
        }

        // Whether there are items on either side; if not, the node has no children.
        private function applyDivision():Boolean
        {
            var node:HierarchyNode = _node;
            var middle:int = _items.middle;
            if (middle == node.first || middle == node.end)
            {
                return false;
            }
            _maker.divide(node, _items.axis, _maker.make(node.level + 1, node.first, middle, _items.leftExtents),
                    _maker.make(node.level + 1, middle, node.end, _items.rightExtents));
            return true;
        }
    }
}
