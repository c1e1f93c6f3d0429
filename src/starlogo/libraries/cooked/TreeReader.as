package starlogo.libraries.cooked
{
    import flash.errors.EOFError;
    import flash.utils.ByteArray;
    import starlogo.engine;
    import starlogo.hierarchy.Hierarchy;
    import starlogo.hierarchy.HierarchyNode;
    import starlogo.hierarchy.PackedTree;
    import starlogo.hierarchy.TreeItems;
    import starlogo.models.cooked.VarInt;
    import starlogo.steps.StepSequence;

    use namespace engine;

    /**
     * Restores a hierarchy from the bytes of a TreeWriter. Only the division of the items is read. The boxes are computed again, in a
     * fraction of the time that dividing takes. So the hierarchy encloses the model, even if the bytes are wrong. If the bytes are right,
     * the hierarchy equals the written one to the last bit.
     *
     * @private
     */
    public final class TreeReader extends StepSequence
    {
        private static const ITEMS_PER_STEP:int = 1500;
        private static const NODES_PER_STEP:int = 300;
        private static const NUMBERS_PER_NODE:int = 5;

        // This is added to the axis of a node that is divided below the thesis's tree.
        private static const BELOW:int = 3;

        private var _bytes:ByteArray;
        private var _hierarchy:Hierarchy;
        private var _order:Vector.<int>;
        private var _isRefused:Boolean = false;

        // _plan has five numbers for each node: its first item, the end of its items, its level, its right child (0 for a leaf), and its
        // axis, plus BELOW if the node is divided below the thesis's tree. The left child is the next node. _extents has the extents of
        // each node.
        private var _plan:Vector.<int> = new Vector.<int>();
        private var _extents:Vector.<Number>;

        // the nodes whose right child has not come yet
        private var _open:Vector.<int> = new Vector.<int>();

        // the node that was measured or made last
        private var _node:int;
        private var _nodes:Vector.<HierarchyNode>;

        /**
         * @param bytes the record, read from its position on
         * @param hierarchy receives the order of its items and its root. It stays as it is if the record does not divide these items
         */
        public function TreeReader(bytes:ByteArray, hierarchy:Hierarchy)
        {
            _bytes = bytes;
            _hierarchy = hierarchy;
            call(addParts);
        }

        private function addParts():void
        {
            var count:int = _hierarchy.itemCount;
            _order = new Vector.<int>(count, true);
            var isListed:Vector.<Boolean> = new Vector.<Boolean>(count, true);
            addToPlan(0, count, 1);
            slices(count, ITEMS_PER_STEP, function(first:int, end:int):void
                {
                    readOrder(first, end, isListed);
                }).repeat(readDivisions).repeat(measureNodes).repeat(makeNodes);
        }

        /** @inheritDoc */
        override public function step():Boolean
        {
            try
            {
                return super.step() && !_isRefused;
            }
            catch (error:EOFError)
            {
                _isRefused = true;
            }
            return false;
        }

        // Every item must come exactly once.
        private function readOrder(first:int, end:int, isListed:Vector.<Boolean>):void
        {
            var bytes:ByteArray = _bytes;
            var order:Vector.<int> = _order;
            var count:int = order.length;
            var width:int = TreeWriter.widthFor(count);
            for (var i:int = first; i < end; i++)
            {
                var item:int = width == 1 ? bytes.readUnsignedByte() : (width == 2 ? bytes.readUnsignedShort() : bytes.readInt());
                if (item < 0 || item >= count || isListed[item])
                {
                    _isRefused = true;
                    return;
                }
                isListed[item] = true;
                order[i] = item;
            }
        }

        private function addToPlan(first:int, end:int, level:int):void
        {
            _plan.push(first, end, level, 0, 0);
        }

        // The children of a node must divide its items between them. Below the thesis's leaves, deep nodes must be divided as a HierarchyBuilder
        // divides them, so that a file cannot make a tree as deep as the number of its items.
        private function readDivisions():Boolean
        {
            for (var i:int = 0; i < NODES_PER_STEP; i++)
            {
                var at:int = _plan.length - NUMBERS_PER_NODE;
                var code:int = VarInt.read(_bytes);
                if (code > 0)
                {
                    var first:int = _plan[at];
                    var level:int = _plan[at + 2];
                    var middle:int = first + (code - 1) / 6;
                    var division:int = (code - 1) % 6;
                    _isRefused = middle <= first || middle >= _plan[at + 1] || (division < BELOW ? level >= _hierarchy.maxDepth
                            : PackedTree.isHalved(level) && middle != (first + _plan[at + 1]) >> 1);
                    _plan[at + 4] = division;
                    _open.push(at);
                    addToPlan(first, middle, level + 1);
                }
                else if (code == 0 && _open.length > 0)
                {
                    var parent:int = _open.pop();
                    _plan[parent + 3] = _plan.length / NUMBERS_PER_NODE;
                    addToPlan(_plan[at + 1], _plan[parent + 1], _plan[parent + 2] + 1);
                }
                else
                {
                    _isRefused = code < 0;
                    _node = _plan.length / NUMBERS_PER_NODE;
                    _extents = new Vector.<Number>(6 * _node, true);
                    return false;
                }
                if (_isRefused)
                {
                    return false;
                }
            }
            return true;
        }

        // Goes from the last node to the first, because children come after their parents.
        private function measureNodes():Boolean
        {
            var items:int = 0;
            _hierarchy.order = _order;
            while (_node > 0 && items < ITEMS_PER_STEP)
            {
                _node--;
                var at:int = NUMBERS_PER_NODE * _node;
                var right:int = _plan[int(at + 3)];
                if (right > 0)
                {
                    unite(6 * _node, 6 * _node + 6, 6 * right);
                    items += 2;
                }
                else
                {
                    TreeItems.writeBounds(_hierarchy, _plan[at], _plan[int(at + 1)], _extents, 6 * _node);
                    items += _plan[int(at + 1)] - _plan[at];
                }
            }
            if (_node > 0)
            {
                return true;
            }
            _node = _plan.length / NUMBERS_PER_NODE;
            _hierarchy.setExtents(_extents);
            _nodes = new Vector.<HierarchyNode>(_node);
            return false;
        }

        private function unite(at:int, left:int, right:int):void
        {
            var extents:Vector.<Number> = _extents;
            for (var i:int = 0; i < 3; i++)
            {
                extents[int(at + i)] = Math.min(extents[int(left + i)], extents[int(right + i)]);
                extents[int(at + i + 3)] = Math.max(extents[int(left + i + 3)], extents[int(right + i + 3)]);
            }
        }

        private function makeNodes():Boolean
        {
            var end:int = Math.max(0, _node - NODES_PER_STEP);
            while (_node > end)
            {
                _node--;
                var at:int = NUMBERS_PER_NODE * _node;
                var node:HierarchyNode = _hierarchy.makeNode(_plan[int(at + 2)], _plan[at], _plan[int(at + 1)], _extents, 6 * _node);
                _nodes[_node] = node;
                var right:int = _plan[int(at + 3)];
                if (right > 0)
                {
                    var division:int = _plan[int(at + 4)];
                    node.divide(division % BELOW, _nodes[int(_node + 1)], _nodes[right], division < BELOW ? node.level : HierarchyNode.LARGEST_DEPTH);
                }
            }
            _hierarchy.root = _nodes[0];
            return _node > 0;
        }
    }
}
