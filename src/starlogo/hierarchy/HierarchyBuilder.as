package starlogo.hierarchy
{
    import starlogo.engine;
    import starlogo.steps.StepSequence;

    use namespace engine;

    /**
     * Builds a hierarchy from the root down (thesis §4.4): divides a node's items between two new nodes, and their items in turn. Items are
     * triangles, or vertices if there are no triangles.
     *
     * <p>For a finished hierarchy of triangles, it goes on below the thesis's leaves, down to a few triangles each, and packs all boxes for
     * tests of triangles and rays. A hierarchy that was read with all its nodes is not divided again.</p>
     *
     * <p>An item goes to the side of the split on which the centre of its extents is. The thesis splits halfway along the box's longest
     * axis, or at the mean. If that leaves all triangles on one side, the split is halfway along the axis on which their centres are spread
     * most. A node is a leaf if all its items have the same centre. Below the thesis's leaves such a node is divided by the number of its
     * items. So is every node there from level Tolerances.NESTED_LEVELS on. Models of many parallel needles would make trees as deep as the
     * number of their triangles otherwise.</p>
     *
     * <p>The thesis defines minVerticesToSplit in two ways: in §4.4 as the number of vertices up to which a node is not split, in §4.8 as
     * the smallest number that is split. A node with exactly that many vertices is a leaf here, as in §4.4, because §4.4 describes the
     * algorithm and §4.8 only lists its parameters.</p>
     *
     * <p>It works in steps, each of one or two milliseconds for thousands of items. The steps throw an ArgumentError if a coordinate is
     * larger than 1e60.</p>
     *
     * @private
     */
    public final class HierarchyBuilder extends StepSequence
    {
        // The approximate work of a step, in items. Making a node counts as ITEMS_PER_NODE items.
        private static const ITEMS_PER_STEP:int = 1000;
        private static const ITEMS_PER_NODE:int = 10;

        private var _hierarchy:Hierarchy;
        private var _items:TreeItems;

        // Below the thesis's leaves, it takes the boxes. The nodes do not stay.
        private var _tree:PackedTree = null;

        // The nodes still to visit, the next one last. Whether the next one is being divided, and whether along the axis of the largest
        // spread.
        private var _waiting:Vector.<HierarchyNode>;
        private var _isDividing:Boolean = false;
        private var _isBySpread:Boolean;

        // The extents of the two halves of a node that is divided by the number of its items.
        private var _lowExtents:Vector.<Number> = new Vector.<Number>(6, true);
        private var _highExtents:Vector.<Number> = new Vector.<Number>(6, true);

        /**
         * @param hierarchy receives the nodes, and the order of its items; if it has nodes, the boxes below them
         */
        public function HierarchyBuilder(hierarchy:Hierarchy)
        {
            _hierarchy = hierarchy;
            call(takeItems);
        }

        private function takeItems():void
        {
            _items = _hierarchy.items;
            if (_items == null)
            {
                _items = new TreeItems(_hierarchy);
                slices(_items.order.length, ITEMS_PER_STEP, _items.measure);
            }
            call(beginRoot).repeat(divide);
        }

        private function beginRoot():void
        {
            if (_hierarchy.root == null)
            {
                _hierarchy.order = _items.order;
                _hierarchy.setExtents(_items.bounds);
                _hierarchy.root = _hierarchy.makeNode(1, 0, _items.order.length, _items.bounds);
                _hierarchy.items = _hierarchy.hasTriangles ? _items : null;
            }
            else
            {
                _tree = _hierarchy.tree = new PackedTree(_hierarchy.root);
                _hierarchy.items = null;
            }
            _waiting = new <HierarchyNode>[_hierarchy.root];
        }

        private function divide():Boolean
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
            return node.level < _hierarchy.maxDepth && node.end - node.first > 1
                && _hierarchy.hasMoreVertices(node.first, node.end, _hierarchy.minVerticesToSplit);
        }

        private function beginNode(node:HierarchyNode):void
        {
            var axis:int = node.longestAxis();
            var split:Number = 2 * (axis == 0 ? node.x : (axis == 1 ? node.y : node.z));
            _isBySpread = false;
            if (_hierarchy.splitByMean && _tree == null)
            {
                split = _items.meanOf(node.first, node.end, axis);
            }
            _items.beginDivision(node.first, node.end, axis, split);
        }

        // Continues with a node. Returns whether more remains to do.
        private function advance(node:HierarchyNode):Boolean
        {
            if (_tree != null && PackedTree.isHalved(node.level))
            {
                halve(node);
                return false;
            }
            if (_items.divideSome(ITEMS_PER_STEP))
            {
                return true;
            }
            var middle:int = _items.middle;
            if (middle == node.first || middle == node.end)
            {
                if (!_isBySpread)
                {
                    _isBySpread = true;
                    return _items.beginWhereCentresSpread(node.first, node.end) || _tree != null;
                }
                if (_tree != null)
                {
                    halve(node);
                }
                return false;
            }
            divideAt(middle, node, _items.axis, _items.leftExtents, _items.rightExtents);
            return false;
        }

        // Divides a node by the number of its items.
        private function halve(node:HierarchyNode):void
        {
            var middle:int = (node.first + node.end) >> 1;
            TreeItems.writeBounds(_hierarchy, node.first, middle, _lowExtents);
            TreeItems.writeBounds(_hierarchy, middle, node.end, _highExtents);
            divideAt(middle, node, node.longestAxis(), _lowExtents, _highExtents);
        }

        private function divideAt(middle:int, node:HierarchyNode, axis:int, low:Vector.<Number>, high:Vector.<Number>):void
        {
            node.divide(axis, _hierarchy.makeNode(node.level + 1, node.first, middle, low), _hierarchy.makeNode(node.level + 1, middle, node.end, high),
                    _tree != null ? HierarchyNode.LARGEST_DEPTH : node.level);
        }
    }
}
