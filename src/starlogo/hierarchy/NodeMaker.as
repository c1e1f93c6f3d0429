package starlogo.hierarchy
{
    /**
     * Makes the nodes of a tree from the root down. A BoxTreeBuilder or a CookedTree says where each node is divided.
     *
     * <p>Until <code>complete()</code>, the tree's columns are longer than the number of nodes. They begin with room for the nodes of most models,
     * because longer columns are copies.</p>
     *
     * @private
     */
    public final class NodeMaker
    {
        private var _tree:BoxTree;
        private var _count:int = 0;

        /**
         * Makes the root, without children.
         *
         * @param tree without nodes
         */
        public function NodeMaker(tree:BoxTree)
        {
            var room:int = Math.min(2 * tree.itemCount, 0.4 * tree.itemCount + 1000);
            _tree = tree;
            tree.boxes = new Vector.<Number>(6 * room);
            tree.left = new Vector.<int>(room);
            tree.first = new Vector.<int>(room);
            tree.end = new Vector.<int>(room);
            tree.endsUpToDepth = new Vector.<int>(room);
            tree.splits = new Vector.<int>(room);
            addNode(0, tree.itemCount, 1);
        }

        /**
         * Gives a node two children. They have no boxes yet.
         *
         * @param axis the axis along which it is split
         * @param middle the slot of the right child's first item
         * @param isBelow whether the node is a leaf, or below one
         * @return the left child
         */
        public function divide(node:int, axis:int, middle:int, isBelow:Boolean):int
        {
            var level:int = _tree.levelOf(node);
            var child:int = _count;
            _tree.left[node] = child;
            _tree.endsUpToDepth[node] = isBelow ? BoxTree.LARGEST_DEPTH : level;
            _tree.splits[node] = level << 2 | axis;
            addNode(_tree.first[node], middle, level + 1);
            addNode(middle, _tree.end[node], level + 1);
            return child;
        }

        /** Ends the making. */
        public function complete():void
        {
            _tree.cutTo(_count);
        }

        private function addNode(first:int, end:int, level:int):void
        {
            var node:int = _count;
            if (node == _tree.left.length)
            {
                makeRoom(2 * node);
            }
            _tree.first[node] = first;
            _tree.end[node] = end;
            _tree.endsUpToDepth[node] = BoxTree.EXACT;
            _tree.splits[node] = level << 2;
            _count = node + 1;
        }

        private function makeRoom(count:int):void
        {
            _tree.boxes.length = 6 * count;
            _tree.left.length = _tree.first.length = _tree.end.length = _tree.endsUpToDepth.length = _tree.splits.length = count;
        }
    }
}
