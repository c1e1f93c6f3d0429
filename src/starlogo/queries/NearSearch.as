package starlogo.queries
{
    /**
     * Finds the rows of a tree of places that are near a place, the nearest nodes first. Distances are compared as squares, in the order of arithmetic
     * (x x + y y) + z z, in which that to a box is never more than that to a place in it, to the last bit.
     *
     * @private
     */
    public final class NearSearch
    {
        private var _tree:RowTree;
        private var _found:FoundRows;

        // Whether rows are only counted, and all of them: then nodes are counted as a whole.
        private var _countsNodes:Boolean = false;
        private var _x:Number = 0;
        private var _y:Number = 0;
        private var _z:Number = 0;

        // Nodes that are to be visited yet, and their squared distances.
        private var _nodes:Vector.<int> = new Vector.<int>();
        private var _squares:Vector.<Number> = new Vector.<Number>();

        /** No search yet. */
        public function NearSearch()
        {
        }

        /**
         * Finds rows.
         *
         * @param tree of places
         * @param x the place that they are near to
         * @param y the place that they are near to
         * @param z the place that they are near to
         * @param found says which are wanted, and takes them, in no order
         */
        public function find(tree:RowTree, x:Number, y:Number, z:Number, found:FoundRows):void
        {
            _tree = tree;
            _found = found;
            _x = x;
            _y = y;
            _z = z;
            _countsNodes = found.most == FoundRows.NUMBER && found.test == null;
            var nodes:Vector.<int> = _nodes;
            var squares:Vector.<Number> = _squares;
            var firstLeaf:int = tree.firstLeaf;
            var waiting:int = begin();
            while (waiting > 0)
            {
                waiting--;
                var node:int = nodes[waiting];
                if (squares[waiting] > found.limit)
                {
                    continue;
                }
                if (node < firstLeaf)
                {
                    waiting = open(node << 1, waiting);
                }
                else
                {
                    visit(tree.starts[int(node - firstLeaf)], tree.starts[int(node + 1 - firstLeaf)], found);
                }
            }
        }

        // Has the first nodes wait; returns how many.
        private function begin():int
        {
            if (_tree.count == 0)
            {
                return 0;
            }
            if (_found.skipped < 0)
            {
                return measure(1, 0);
            }
            if (!_countsNodes)
            {
                return beginBeside(_tree.leafOf(_found.skipped));
            }
            // counted below
            if (_tree.squareTo(_found.skipped, _x, _y, _z) <= _found.limit)
            {
                _found.count--;
            }
            return measure(1, 0);
        }

        // Has a leaf be the next, which is likely to have the nearest, and after it all that is beside the way there from the root.
        private function beginBeside(leaf:int):int
        {
            var up:int = 0;
            while (leaf >> up > 1)
            {
                up++;
            }
            var waiting:int = 0;
            while (up > 0)
            {
                up--;
                waiting = measure(leaf >> up ^ 1, waiting);
            }
            _nodes[waiting] = leaf;
            _squares[waiting] = 0;
            return waiting + 1;
        }

        // Has a node and its sibling wait, the nearer to be the next; returns how many nodes wait.
        private function open(node:int, first:int):int
        {
            var second:int = measure(node, first);
            var waiting:int = measure(node + 1, second);
            if (waiting == first + 2)
            {
                var square:Number = _squares[first];
                if (square < _squares[second])
                {
                    _squares[first] = _squares[second];
                    _squares[second] = square;
                    _nodes[first] = node + 1;
                    _nodes[second] = node;
                }
            }
            return waiting;
        }

        // Has a node wait whose box is no farther than the limit, with its squared distance. One of which all rows count is counted at once. Returns
        // how many nodes wait.
        private function measure(node:int, waiting:int):int
        {
            var boxes:Vector.<Number> = _tree.nodeBoxes;
            var box:int = RowTree.PER_BOX * node;
            var toX:Number = boxes[box] - _x;
            if (toX < 0)
            {
                toX = _x - boxes[int(box + 3)];
                if (toX < 0)
                {
                    toX = 0;
                }
            }
            var toY:Number = boxes[int(box + 1)] - _y;
            if (toY < 0)
            {
                toY = _y - boxes[int(box + 4)];
                if (toY < 0)
                {
                    toY = 0;
                }
            }
            var toZ:Number = boxes[int(box + 2)] - _z;
            if (toZ < 0)
            {
                toZ = _z - boxes[int(box + 5)];
                if (toZ < 0)
                {
                    toZ = 0;
                }
            }
            var square:Number = toX * toX + toY * toY + toZ * toZ;
            if (square > _found.limit)
            {
                return waiting;
            }
            if (_countsNodes)
            {
                toX = _x - boxes[box];
                toY = _y - boxes[int(box + 1)];
                toZ = _z - boxes[int(box + 2)];
                var farX:Number = boxes[int(box + 3)] - _x;
                var farY:Number = boxes[int(box + 4)] - _y;
                var farZ:Number = boxes[int(box + 5)] - _z;
                farX = toX > farX ? toX : farX;
                farY = toY > farY ? toY : farY;
                farZ = toZ > farZ ? toZ : farZ;
                if (farX * farX + farY * farY + farZ * farZ <= _found.limit)
                {
                    _found.count += _tree.countIn(node);
                    return waiting;
                }
            }
            _nodes[waiting] = node;
            _squares[waiting] = square;
            return waiting + 1;
        }

        // Looks at the rows of a leaf. What is only kept or counted is so here, because a call for each row costs as much as the row.
        private function visit(start:int, end:int, found:FoundRows):void
        {
            var xs:Vector.<Number> = _tree.x;
            var ys:Vector.<Number> = _tree.y;
            var zs:Vector.<Number> = _tree.z;
            var atX:Number = _x;
            var atY:Number = _y;
            var atZ:Number = _z;
            var rows:Vector.<int> = _tree.rows;
            var test:RowTest = found.test;
            var skipped:int = found.skipped;
            var countsAll:Boolean = _countsNodes;
            var limit:Number = found.limit;
            var most:int = found.most;
            var foundRows:Vector.<int> = found.rows;
            var foundSquares:Vector.<Number> = found.squares;
            var ranks:Vector.<int> = found.ranks;
            var count:int = found.count;
            for (var slot:int = start; slot < end; slot++)
            {
                var toX:Number = xs[slot] - atX;
                var toY:Number = ys[slot] - atY;
                var toZ:Number = zs[slot] - atZ;
                var square:Number = toX * toX + toY * toY + toZ * toZ;
                if (square > limit)
                {
                    continue;
                }
                if (countsAll)
                {
                    count++;
                    continue;
                }
                var row:int = rows[slot];
                if (row == skipped)
                {
                    continue;
                }
                if (test != null)
                {
                    if (!test.accepts(row))
                    {
                        continue;
                    }
                }
                if (most == 1)
                {
                    if (count == 0 || square < limit || ranks[row] < ranks[foundRows[0]])
                    {
                        count = 1;
                        limit = foundSquares[0] = square;
                        foundRows[0] = row;
                    }
                    continue;
                }
                if (most == FoundRows.ALL)
                {
                    foundRows[count] = row;
                    foundSquares[count] = square;
                }
                else if (most != FoundRows.NUMBER)
                {
                    found.add(row, square);
                    count = found.count;
                    limit = found.limit;
                    continue;
                }
                count++;
            }
            found.count = count;
            found.limit = limit;
        }
    }
}
