package starlogo.queries
{
    /**
     * Counts the rows of a tree of places that are near a place. If all rows count, it counts a node that is wholly within the distance without
     * a look at its rows. It compares squared distances, computed as NearSearch computes them.
     *
     * @private
     */
    public final class CountSearch
    {
        private var _tree:RowTree;

        // The place, the squared distance, and the nodes that wait for a visit.
        private var _place:Vector.<Number> = new Vector.<Number>(3, true);
        private var _limit:Number = 0;
        private var _nodes:Vector.<int> = new Vector.<int>();

        /**
         * Counts the rows near a place.
         *
         * @param tree a tree of places
         * @param limit the square of the largest distance
         * @param filter the rows that count. Its accepts is not asked
         */
        public function count(tree:RowTree, x:Number, y:Number, z:Number, limit:Number, filter:RowFilter):int
        {
            _tree = tree;
            _place[0] = x;
            _place[1] = y;
            _place[2] = z;
            _limit = limit;
            _nodes[0] = 1;
            var waiting:int = tree.count > 0 ? 1 : 0;
            var counted:int = 0;
            while (waiting > 0)
            {
                waiting--;
                var node:int = _nodes[waiting];
                if (isBeyond(node) || !tree.breeds.mayHave(node, filter.breeds))
                {
                    continue;
                }
                if (!filter.excludes && isWithin(node))
                {
                    counted += tree.countIn(node);
                }
                else if (node < tree.firstLeaf)
                {
                    _nodes[waiting] = node << 1;
                    _nodes[waiting + 1] = (node << 1) + 1;
                    waiting += 2;
                }
                else
                {
                    counted += countLeaf(node - tree.firstLeaf, filter);
                }
            }
            // the agent that asks was counted too
            return filter.askerRow >= 0 && filter.admits(filter.askerRow) && tree.squareTo(filter.askerRow, x, y, z) <= limit ? counted - 1 : counted;
        }

        private function countLeaf(leaf:int, filter:RowFilter):int
        {
            var xs:Vector.<Number> = _tree.middles.x;
            var ys:Vector.<Number> = _tree.middles.y;
            var zs:Vector.<Number> = _tree.middles.z;
            var x:Number = _place[0];
            var y:Number = _place[1];
            var z:Number = _place[2];
            var limit:Number = _limit;
            var excludes:Boolean = filter.excludes;
            var counted:int = 0;
            var passedOver:int = 0;
            var end:int = _tree.starts[int(leaf + 1)];
            for (var slot:int = _tree.starts[leaf]; slot < end; slot++)
            {
                var toX:Number = xs[slot] - x;
                var toY:Number = ys[slot] - y;
                var toZ:Number = zs[slot] - z;
                if (toX * toX + toY * toY + toZ * toZ > limit)
                {
                    continue;
                }
                if (excludes && !filter.admits(_tree.rows[slot]))
                {
                    passedOver++;
                    continue;
                }
                counted++;
            }
            _tree.breeds.passOver(passedOver);
            return counted;
        }

        // Whether the whole box of a node is beyond the distance.
        private function isBeyond(node:int):Boolean
        {
            var boxes:Vector.<Number> = _tree.nodeBoxes;
            var box:int = RowTree.PER_BOX * node;
            var square:Number = 0;
            for (var axis:int = 0; axis < 3; axis++)
            {
                var to:Number = boxes[int(box + axis)] - _place[axis];
                if (to < 0)
                {
                    to = _place[axis] - boxes[int(box + axis + 3)];
                }
                if (to > 0)
                {
                    square += to * to;
                }
            }
            return square > _limit;
        }

        // Whether the whole box of a node is within the distance.
        private function isWithin(node:int):Boolean
        {
            var boxes:Vector.<Number> = _tree.nodeBoxes;
            var box:int = RowTree.PER_BOX * node;
            var square:Number = 0;
            for (var axis:int = 0; axis < 3; axis++)
            {
                var to:Number = _place[axis] - boxes[int(box + axis)];
                var far:Number = boxes[int(box + axis + 3)] - _place[axis];
                if (far > to)
                {
                    to = far;
                }
                square += to * to;
            }
            return square <= _limit;
        }
    }
}
