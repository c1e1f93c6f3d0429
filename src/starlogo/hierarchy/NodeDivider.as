package starlogo.hierarchy
{
    import starlogo.engine;
    import starlogo.steps.Steps;

    use namespace engine;

    /**
     * Divides a node's items between two others, and those of these in turn, in steps (thesis §4.4).
     *
     * <p>An item goes to the side of the split that the centre of its extents is on. The thesis's splitting point, halfway along the
     * longest axis of the box or at the mean, may leave all triangles on one side; then it is halfway along the axis on which their
     * centres spread most. A node whose items all have the same centre is a leaf; below the thesis's leaves it is divided by number.</p>
     *
     * <p>On minVerticesToSplit the thesis says two things: in §4.4 it is the number of vertices up to which a node is not split
     * any further, in §4.8 the smallest number that is split. They differ for a node of just as many; here it is a leaf, as in
     * §4.4, which describes the algorithm, while §4.8 lists its parameters.</p>
     */
    internal final class NodeDivider implements Steps
    {
        // About how much a step does, and how many items take as long as making a node.
        private static const ITEMS_PER_STEP:int = 1000;
        private static const ITEMS_PER_NODE:int = 10;

        /** The nodes that were looked at, parents before their children. */
        public var nodes:Vector.<HierarchyNode> = new Vector.<HierarchyNode>();

        /** A node of no more vertices is a leaf. */
        public var minVerticesToSplit:int = 1;

        /** A node on this level is a leaf. */
        public var maxDepth:int = 1;

        /** Whether to split at the mean. */
        public var splitByMean:Boolean = false;

        /** In place of all these, if it is not 0: a node of no more items is a leaf, and what is divided is below the thesis's leaves. */
        public var leafSize:int = 0;

        private var _items:Items;
        private var _maker:NodeMaker;

        // Those that are to be looked at yet, the next one last; whether that is being divided, and no longer along its longest axis.
        private var _waiting:Vector.<HierarchyNode>;
        private var _isDividing:Boolean = false;
        private var _isBySpread:Boolean;

        // What its items' coordinates add up to so far, and the item that comes next.
        private var _axis:int;
        private var _isAveraging:Boolean;
        private var _sum:Number;
        private var _next:int;

        /**
         * @param root the node to begin with; children that it has stay
         * @param items what is divided
         * @param maker makes the nodes
         */
        public function NodeDivider(root:HierarchyNode, items:Items, maker:NodeMaker)
        {
            _waiting = new <HierarchyNode>[root];
            _items = items;
            _maker = maker;
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
                        begin(node);
                    }
                }
                if (_isDividing)
                {
                    _isDividing = advance(node);
                    left -= node.end - node.first;
                }
                if (!_isDividing)
                {
                    nodes.push(_waiting.pop());
                    if (node.low != null)
                    {
                        _waiting.push(node.high, node.low);
                    }
                }
            }
            return _waiting.length > 0;
        }

        private function isLarge(node:HierarchyNode):Boolean
        {
            var count:int = node.end - node.first;
            if (leafSize > 0)
            {
                return count > leafSize;
            }
            var few:int = minVerticesToSplit;
            if (node.level >= maxDepth || count == 1)
            {
                return false;
            }
            if (!node.hierarchy.hasTriangles)
            {
                return count > few;
            }
            // so many different triangles have more vertices in any case
            return count > few * (few - 1) * (few - 2) / 6 || node.vertexCount > few;
        }

        private function begin(node:HierarchyNode):void
        {
            _axis = node.longestAxis();
            _isBySpread = false;
            _isAveraging = splitByMean;
            if (_isAveraging)
            {
                _sum = 0;
                _next = node.first;
                return;
            }
            var centre:Number = _axis == 0 ? node.x : (_axis == 1 ? node.y : node.z);
            _items.beginDivision(node.first, node.end, _axis, 2 * centre);
        }

        // Goes on with a node; returns whether there is more to do.
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
                    return _items.beginWhereCentresSpread(node.first, node.end) || leafSize > 0;
                }
                if (leafSize == 0)
                {
                    return false;
                }
                left = right = middle == node.first ? right : left;
                middle = (node.first + node.end) >> 1;
            }
            _maker.divide(node, _items.axis, _maker.make(node.level + 1, node.first, middle, left),
                    _maker.make(node.level + 1, middle, node.end, right), leafSize > 0 ? HierarchyNode.LARGEST_DEPTH : node.level);
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
