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
         * @param x of the place that they are near to
         * @param y likewise
         * @param z likewise
         * @param found says which are wanted, and takes them, in no order
         */
        public function find(tree:RowTree, x:Number, y:Number, z:Number, found:FoundRows):void
        {
            _tree = tree;
            _x = x;
            _y = y;
            _z = z;
            var nodes:Vector.<int> = _nodes;
            var squares:Vector.<Number> = _squares;
            var firstLeaf:int = tree.firstLeaf;
            var countsNodes:Boolean = found.most == FoundRows.NUMBER && found.test == null;
            var own:int = found.skipped < 0 ? 0 : tree.leafOf(found.skipped);
            var waiting:int = own == 0 ? begin() : beginBeside(own);
            while (waiting > 0)
            {
                waiting--;
                var node:int = nodes[waiting];
                if (squares[waiting] > found.limit)
                {
                    continue;
                }
                if (countsNodes && node != own && isWithin(node, found.limit))
                {
                    found.count += tree.countIn(node);
                }
                else if (node < firstLeaf)
                {
                    open(node << 1, waiting);
                    waiting += 2;
                }
                else
                {
                    visit(tree.starts[int(node - firstLeaf)], tree.starts[int(node + 1 - firstLeaf)], found);
                }
            }
        }

        // Has the root wait, if there is one; returns how many nodes wait.
        private function begin():int
        {
            _nodes[0] = 1;
            _squares[0] = 0;
            return _tree.count > 0 ? 1 : 0;
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
                measure(leaf >> up ^ 1, waiting);
                waiting++;
            }
            _nodes[waiting] = leaf;
            _squares[waiting] = 0;
            return waiting + 1;
        }

        // Has a node and its sibling wait, the nearer to be the next.
        private function open(node:int, waiting:int):void
        {
            var top:int = waiting + 1;
            measure(node, waiting);
            measure(node + 1, top);
            var square:Number = _squares[waiting];
            if (square < _squares[top])
            {
                _squares[waiting] = _squares[top];
                _squares[top] = square;
                _nodes[waiting] = node + 1;
                _nodes[top] = node;
            }
        }

        // Has a node wait, with the squared distance to its box.
        private function measure(node:int, waiting:int):void
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
            _nodes[waiting] = node;
            _squares[waiting] = toX * toX + toY * toY + toZ * toZ;
        }

        // Whether all of a node's box is within a distance.
        private function isWithin(node:int, limit:Number):Boolean
        {
            var boxes:Vector.<Number> = _tree.nodeBoxes;
            var box:int = RowTree.PER_BOX * node;
            var toX:Number = _x - boxes[box];
            var toY:Number = _y - boxes[int(box + 1)];
            var toZ:Number = _z - boxes[int(box + 2)];
            var farX:Number = boxes[int(box + 3)] - _x;
            var farY:Number = boxes[int(box + 4)] - _y;
            var farZ:Number = boxes[int(box + 5)] - _z;
            toX = toX > farX ? toX : farX;
            toY = toY > farY ? toY : farY;
            toZ = toZ > farZ ? toZ : farZ;
            return toX * toX + toY * toY + toZ * toZ <= limit;
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
            var limit:Number = found.limit;
            var most:int = found.most;
            var foundRows:Vector.<int> = found.rows;
            var foundSquares:Vector.<Number> = found.squares;
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
                var row:int = rows[slot];
                if (row == skipped || (test != null && !test.accepts(row)))
                {
                    continue;
                }
                if (most != FoundRows.ALL && most != FoundRows.NUMBER)
                {
                    limit = found.add(row, square);
                    continue;
                }
                if (most == FoundRows.ALL)
                {
                    foundRows[count] = row;
                    foundSquares[count] = square;
                }
                count++;
            }
            if (most == FoundRows.ALL || most == FoundRows.NUMBER)
            {
                found.count = count;
            }
        }
    }
}
