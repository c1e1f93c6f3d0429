package starlogo.hierarchy
{
    import starlogo.engine;
    import starlogo.steps.Steps;

    use namespace engine;

    /**
     * Divides a node's items between two new nodes, and their items in turn, in steps (thesis §4.4).
     *
     * <p>An item goes to the side of the split on which the centre of its extents is. The thesis splits halfway along the box's longest
     * axis, or at the mean. If that leaves all triangles on one side, the split is halfway along the axis on which their centres are spread
     * most. A node is a leaf if all its items have the same centre. Below the thesis's leaves such a node is divided by the number of its
     * items.</p>
     *
     * <p>The thesis defines minVerticesToSplit in two ways: in §4.4 as the number of vertices up to which a node is not split, in §4.8 as
     * the smallest number that is split. A node with exactly that many vertices is a leaf here, as in §4.4, because §4.4 describes the
     * algorithm and §4.8 only lists its parameters.</p>
     *
     * @private
     */
    public final class NodeDivider implements Steps
    {
        // The approximate work of a step, in items. Making a node counts as ITEMS_PER_NODE items.
        private static const ITEMS_PER_STEP:int = 1000;
        private static const ITEMS_PER_NODE:int = 10;

        private var _minVerticesToSplit:int;
        private var _maxDepth:int;
        private var _splitByMean:Boolean;

        // If not null, it replaces the three fields above: it tells which nodes are leaves, and takes the boxes. Nodes below the thesis's
        // leaves do not stay.
        private var _tree:PackedTree = null;

        private var _items:TreeItems;
        private var _maker:NodeMaker;

        // The nodes still to visit, the next one last. Whether the next one is being divided, and whether along the axis of the largest
        // spread.
        private var _waiting:Vector.<HierarchyNode>;
        private var _isDividing:Boolean = false;
        private var _isBySpread:Boolean;

        // While a mean is computed: the axis, whether it is unfinished, the sum of the items' coordinates so far, and the next item.
        private var _axis:int;
        private var _isAveraging:Boolean;
        private var _sum:Number;
        private var _next:int;

        /**
         * @param minVerticesToSplit a node with at most this many vertices is a leaf
         * @param maxDepth a node on this level is a leaf
         * @param splitByMean whether to split at the mean
         */
        public function NodeDivider(minVerticesToSplit:int = 1, maxDepth:int = 1, splitByMean:Boolean = false)
        {
            _minVerticesToSplit = minVerticesToSplit;
            _maxDepth = maxDepth;
            _splitByMean = splitByMean;
        }

        /** Begins with the root of a hierarchy whose items are measured. Must be called before the first step. */
        public function begin(root:HierarchyNode, items:TreeItems, maker:NodeMaker):void
        {
            _waiting = new <HierarchyNode>[root];
            _items = items;
            _maker = maker;
        }

        /**
         * Begins with a finished hierarchy of measured triangles. Its leaves are divided down to a few triangles each, and all boxes are
         * packed, for tests of triangles and rays. A hierarchy that was read with all its nodes is not divided again.
         */
        public function beginBelow(hierarchy:Hierarchy):void
        {
            _tree = hierarchy.tree = new PackedTree(hierarchy.root, hierarchy.items.bounds);
            begin(hierarchy.root, hierarchy.items, _tree.maker);
        }

        /** @inheritDoc */
        public function step():Boolean
        {
            var left:int = ITEMS_PER_STEP;
            while (left > 0 && _waiting.length > 0)
            {
                var node:HierarchyNode = _waiting[_waiting.length - 1];
                if (!_isDividing)
                {
                    _isDividing = node.low == null && isLarge(node);
                    left -= ITEMS_PER_NODE;
                    if (_isDividing)
                    {
                        beginNode(node);
                    }
                }
                if (_isDividing)
                {
                    _isDividing = advance(node);
                    left -= node.end - node.first;
                }
                if (!_isDividing)
                {
                    _waiting.pop();
                    if (node.low != null)
                    {
                        _waiting.push(node.high, node.low);
                        if (_tree != null)
                        {
                            _tree.pack(node);
                            node.forgetChildren();
                        }
                    }
                }
            }
            return _waiting.length > 0;
        }

        private function isLarge(node:HierarchyNode):Boolean
        {
            if (_tree != null)
            {
                return PackedTree.isLarge(node);
            }
            var count:int = node.end - node.first;
            var few:int = _minVerticesToSplit;
            if (node.level >= _maxDepth || count == 1)
            {
                return false;
            }
            if (!node.hierarchy.hasTriangles)
            {
                return count > few;
            }
            // n vertices make at most n (n - 1) (n - 2) / 6 different triangles, so a node with more triangles has more vertices.
            return count > few * (few - 1) * (few - 2) / 6 || node.vertexCount > few;
        }

        private function beginNode(node:HierarchyNode):void
        {
            _axis = node.longestAxis();
            _isBySpread = false;
            _isAveraging = _splitByMean;
            if (_isAveraging)
            {
                _sum = 0;
                _next = node.first;
                return;
            }
            var centre:Number = _axis == 0 ? node.x : (_axis == 1 ? node.y : node.z);
            _items.beginDivision(node.first, node.end, _axis, 2 * centre);
        }

        // Continues with a node. Returns whether more remains to do.
        private function advance(node:HierarchyNode):Boolean
        {
            if (_isAveraging)
            {
                averageSome(node);
                return true;
            }
            if (_items.divideSome(ITEMS_PER_STEP))
            {
                return true;
            }
            var left:Vector.<Number> = _items.leftExtents;
            var right:Vector.<Number> = _items.rightExtents;
            var middle:int = _items.middle;
            if (middle == node.first || middle == node.end)
            {
                if (!_isBySpread)
                {
                    _isBySpread = true;
                    return _items.beginWhereCentresSpread(node.first, node.end) || _tree != null;
                }
                if (_tree == null)
                {
                    return false;
                }
                left = right = middle == node.first ? right : left;
                middle = (node.first + node.end) >> 1;
            }
            _maker.divide(node, _items.axis, _maker.make(node.level + 1, node.first, middle, left),
                    _maker.make(node.level + 1, middle, node.end, right), _tree != null ? HierarchyNode.LARGEST_DEPTH : node.level);
            return false;
        }

        private function averageSome(node:HierarchyNode):void
        {
            var end:int = Math.min(_next + ITEMS_PER_STEP, node.end);
            _sum = _items.sumOf(_sum, _next, end, _axis);
            _next = end;
            if (end == node.end)
            {
                _isAveraging = false;
                _items.beginDivision(node.first, end, _axis, _sum / (end - node.first));
            }
        }
    }
}
