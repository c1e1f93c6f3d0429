package starlogo.queries.trees
{
    import starlogo.data.SortableIntList;
    import starlogo.engine;
    import starlogo.queries.SeenAgents;

    use namespace engine;

    /**
     * Finds or counts the rows whose places are near a place.
     *
     * <p>To find rows, it visits the nodes of the tree of places from near to far, because each row that is found may shrink the limit. It begins at
     * the leaf of the agent that asks, and goes on with the nodes beside the path from there to the root. If the agent is not in the tree, it begins
     * at the root. Of two children it visits the nearer one first. If a filter's <code>accepts</code> decides, it visits the nearest of all nodes
     * first, so <code>accepts</code> is called for the nearest rows first.</p>
     *
     * <p>It compares squared distances, always computed as (x x + y y) + z z. In this order rounding never makes the distance to a box larger
     * than the distance to a place in the box.</p>
     *
     * @private
     */
    public final class NearSearch
    {
        private var _seen:SeenAgents;

        // The search under way: what collects its rows, and their tree.
        private var _collector:Collector = null;
        private var _tree:RowTree = null;

        // The place.
        private var _x:Number = 0;
        private var _y:Number = 0;
        private var _z:Number = 0;

        // A stack of the nodes that are still to be visited, and their squared distances.
        private var _stack:SortableIntList = new SortableIntList();

        /** @param seen has the tree of places */
        public function NearSearch(seen:SeenAgents)
        {
            _seen = seen;
        }

        /**
         * Begins a search. Call <code>find()</code> or <code>count()</code> then.
         *
         * @param collector receives the rows. Its limit, a squared distance, says how near they must be
         * @param x the place
         * @param y the place
         * @param z the place
         * @return this search
         */
        public function begin(collector:Collector, x:Number, y:Number, z:Number):NearSearch
        {
            _collector = collector;
            _tree = _seen.treeOfPlaces();
            _x = x;
            _y = y;
            _z = z;
            return this;
        }

        /**
         * Finds the rows near the place.
         *
         * @param cone the rows must be in it too; null for none
         * @return the collector, which has them
         */
        public function find(cone:Cone = null):Collector
        {
            var collector:Collector = _collector;
            var usesAccepts:Boolean = collector.maxCount < Collector.ALL && collector.filter.accepts != null;
            var asker:int = collector.filter.askerRow;
            _stack.count = 0;
            if (asker < 0)
            {
                push(RowTree.ROOT);
            }
            else
            {
                pushBeside(_tree.leafOf(asker));
            }
            while (_stack.count > 0 && collector.limit >= 0)
            {
                if (usesAccepts)
                {
                    putNearestLast(_stack, 0);
                }
                _stack.count--;
                var top:int = _stack.count;
                var node:int = _stack.values[top];
                if (_stack.keys[top] > collector.limit)
                {
                    continue;
                }
                if (node < _tree.firstLeaf)
                {
                    push(node << 1);
                    push((node << 1) + 1);
                    putNearestLast(_stack, top);
                }
                else
                {
                    if (usesAccepts)
                    {
                        collector.askAcceptsBelow(_stack.keys[top]);
                    }
                    visit(node, cone);
                }
            }
            return collector;
        }

        /**
         * Counts the rows near the place. The collector wants all. If the filter excludes none, a node that is wholly within the limit is counted without
         * a look at its rows.
         */
        public function count():int
        {
            var collector:Collector = _collector;
            var countsWholeNodes:Boolean = !collector.filter.excludes && collector.filter.accepts == null;
            var counted:int = 0;
            _stack.count = 0;
            push(RowTree.ROOT);
            while (_stack.count > 0)
            {
                _stack.count--;
                var node:int = _stack.values[_stack.count];
                if (countsWholeNodes && isWithin(node))
                {
                    counted += _tree.countIn(node, collector.filter.askerRow);
                }
                else if (node < _tree.firstLeaf)
                {
                    push(node << 1);
                    push((node << 1) + 1);
                }
                else
                {
                    visit(node, null);
                }
            }
            return counted + collector.endWithCount();
        }

        // Whether the whole box of a node is within the limit.
        private function isWithin(node:int):Boolean
        {
            var boxes:Vector.<Number> = _tree.nodeBoxes;
            var box:int = RowTree.PER_BOX * node;
            var toX:Number = Math.max(_x - boxes[box], boxes[int(box + 3)] - _x);
            var toY:Number = Math.max(_y - boxes[int(box + 1)], boxes[int(box + 4)] - _y);
            var toZ:Number = Math.max(_z - boxes[int(box + 2)], boxes[int(box + 5)] - _z);
            return toX * toX + toY * toY + toZ * toZ <= _collector.limit;
        }

        // Pushes a leaf on the stack, above the nodes beside the path from the root to the leaf. It is visited first, because it probably has the nearest
        // rows.
        private function pushBeside(leaf:int):void
        {
            for (var leaves:int = _tree.firstLeaf >> 1; leaves > 0; leaves >>= 1)
            {
                push(int(leaf / leaves) ^ 1);
            }
            push(leaf);
        }

        // Pushes a node on the stack if its box is within the limit, and it may have rows that count.
        private function push(node:int):void
        {
            var boxes:Vector.<Number> = _tree.nodeBoxes;
            var box:int = RowTree.PER_BOX * node;
            var toX:Number = _x < boxes[box] ? boxes[box] - _x : (_x > boxes[int(box + 3)] ? _x - boxes[int(box + 3)] : 0);
            var toY:Number = _y < boxes[int(box + 1)] ? boxes[int(box + 1)] - _y : (_y > boxes[int(box + 4)] ? _y - boxes[int(box + 4)] : 0);
            var toZ:Number = _z < boxes[int(box + 2)] ? boxes[int(box + 2)] - _z : (_z > boxes[int(box + 5)] ? _z - boxes[int(box + 5)] : 0);
            var square:Number = toX * toX + toY * toY + toZ * toZ;
            if (square <= _collector.limit && _tree.mayHave(node, _collector.filter.breedSet))
            {
                _stack.add(node, square);
            }
        }

        // Gives the collector the rows of a leaf that the filter may admit and that are within the limit.
        private function visit(leaf:int, cone:Cone):void
        {
            var collector:Collector = _collector;
            var filter:RowFilter = collector.filter;
            var boxes:Vector.<Number> = _tree.rowBoxes;
            var atX:Number = _x;
            var atY:Number = _y;
            var atZ:Number = _z;
            var limit:Number = collector.limit;
            var end:int = _tree.startOf(leaf + 1);
            for (var slot:int = _tree.startOf(leaf); slot < end; slot++)
            {
                // the box of a place begins and ends there
                var box:int = RowTree.PER_BOX * slot;
                var toX:Number = boxes[box] - atX;
                var toY:Number = boxes[int(box + 1)] - atY;
                var toZ:Number = boxes[int(box + 2)] - atZ;
                var square:Number = toX * toX + toY * toY + toZ * toZ;
                if (square > limit)
                {
                    continue;
                }
                var row:int = _tree.rows[slot];
                if (!filter.mayAdmit(row))
                {
                    _tree.excludedCount++;
                }
                else if (cone == null || cone.contains(boxes, box))
                {
                    collector.add(row, square);
                    limit = collector.limit;
                }
            }
        }
    }
}
