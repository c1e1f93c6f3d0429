package starlogo.queries
{
    import starlogo.broadphase.Points;

    /**
     * Finds the rows of a tree of places that are near a place. It visits the nearest nodes first.
     *
     * <p>It compares squared distances, always computed as (x x + y y) + z z. In this order rounding never makes the distance to a box larger
     * than the distance to a place in the box.</p>
     *
     * @private
     */
    public final class NearSearch
    {
        private var _tree:RowTree;
        private var _found:Collector;

        // Whether all rows in the limit count. Then a node that is inside the limit is counted as a whole.
        private var _countsNodes:Boolean = false;
        private var _x:Number = 0;
        private var _y:Number = 0;
        private var _z:Number = 0;

        // The nodes that wait for a visit, and their squared distances.
        private var _nodes:Vector.<int> = new Vector.<int>();
        private var _squares:Vector.<Number> = new Vector.<Number>();

        /**
         * Finds the rows near a place.
         *
         * @param tree a tree of places
         * @param x the place
         * @param y the place
         * @param z the place
         * @param found says which rows are wanted, and collects them unsorted
         * @param cone the rows must be in it too; null for none. It does not go with a number of rows alone
         */
        public function find(tree:RowTree, x:Number, y:Number, z:Number, found:Collector, cone:Cone = null):void
        {
            _tree = tree;
            _found = found;
            _x = x;
            _y = y;
            _z = z;
            var nodes:Vector.<int> = _nodes;
            var squares:Vector.<Number> = _squares;
            var firstLeaf:int = tree.firstLeaf;
            _countsNodes = found.countsOnly && !found.filters;
            var asks:Boolean = found.accepts != null && found.wanted < Collector.ALL;
            var waiting:int = begin();
            while (waiting > 0)
            {
                waiting--;
                if (asks)
                {
                    askBefore(waiting);
                    if (found.limit < 0)
                    {
                        return;
                    }
                }
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
                    visit(tree.starts[int(node - firstLeaf)], tree.starts[int(node + 1 - firstLeaf)], found, cone);
                }
            }
        }

        // Puts the first nodes on the waiting list. Returns how many nodes wait.
        private function begin():int
        {
            if (_tree.count == 0)
            {
                return 0;
            }
            if (_found.askerRow < 0)
            {
                return measure(1, 0);
            }
            if (!_countsNodes)
            {
                return beginBeside(_tree.leafOf(_found.askerRow));
            }
            // the skipped row is counted below
            if (_tree.squareTo(_found.askerRow, _x, _y, _z) <= _found.limit)
            {
                _found.count--;
            }
            return measure(1, 0);
        }

        // Makes a leaf the next node, because it probably has the nearest rows. After it come the nodes beside the path from the root to the
        // leaf.
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

        // Makes the nearest of the waiting nodes the last of them. If it is a leaf, this first asks for the rows that are nearer than the leaf.
        private function askBefore(last:int):void
        {
            var nearest:int = last;
            for (var i:int = 0; i < last; i++)
            {
                if (_squares[i] < _squares[nearest])
                {
                    nearest = i;
                }
            }
            var node:int = _nodes[nearest];
            var square:Number = _squares[nearest];
            _nodes[nearest] = _nodes[last];
            _squares[nearest] = _squares[last];
            _nodes[last] = node;
            _squares[last] = square;
            if (node >= _tree.firstLeaf)
            {
                _found.ask(square);
            }
        }

        // Puts a node and its sibling on the waiting list, with the nearer one to be visited next. Returns how many nodes wait.
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

        // Puts a node on the waiting list if its box is within the limit. If all rows in the limit count, and the whole box is within the
        // limit, the node is counted at once. Returns how many nodes wait.
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
            if (square > _found.limit || !_tree.breeds.mayHave(node, _found.breeds))
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

        // Tests the rows of a leaf. Rows that are only kept or counted are handled here, because a call for each row would take as long as the
        // test.
        private function visit(start:int, end:int, found:Collector, cone:Cone):void
        {
            var places:Points = _tree.middles;
            var xs:Vector.<Number> = places.x;
            var ys:Vector.<Number> = places.y;
            var zs:Vector.<Number> = places.z;
            var atX:Number = _x;
            var atY:Number = _y;
            var atZ:Number = _z;
            var rows:Vector.<int> = _tree.rows;
            var filters:Boolean = found.filters;
            var countsOnly:Boolean = found.countsOnly;
            var countsAll:Boolean = _countsNodes;
            var askerRow:int = found.askerRow;
            var keepsFirst:Boolean = found.keepsFirst;
            var narrowAt:int = found.narrowAt;
            var limit:Number = found.limit;
            var foundRows:Vector.<int> = found.rows;
            var keys:Vector.<Number> = found.keys;
            var count:int = found.count;
            var passedOver:int = 0;
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
                if (row == askerRow)
                {
                    continue;
                }
                if (filters)
                {
                    if (!found.admitsMarked(row))
                    {
                        passedOver++;
                        continue;
                    }
                }
                if (cone != null && !cone.contains(places, slot))
                {
                    continue;
                }
                if (keepsFirst)
                {
                    if (count == 0 || square < limit || found.seen.table.list.ranks[row] < found.seen.table.list.ranks[foundRows[0]])
                    {
                        count = 1;
                        limit = keys[0] = square;
                        foundRows[0] = row;
                    }
                    continue;
                }
                if (countsOnly)
                {
                    count++;
                    continue;
                }
                foundRows[count] = row;
                keys[count] = square;
                count++;
                if (count == narrowAt)
                {
                    found.count = count;
                    found.narrow();
                    count = found.count;
                    limit = found.limit;
                }
            }
            found.count = count;
            found.limit = limit;
            _tree.breeds.passOver(passedOver);
        }
    }
}
