// This file is long because its loops are written out.
package starlogo.queries
{
    import starlogo.geometry.Placement;
    import starlogo.geometry.Tolerances;
    import starlogo.geometry.Trigonometry;

    /**
     * A balanced tree of boxes around the places of a table's rows: finds those that are near a place, or nearest to it, however they
     * are spread (Bentley, "Multidimensional Binary Search Trees", 1975, with boxes around what is on either side).
     *
     * <p>The nodes are numbered as in a heap: 1 is the root, the children of node i are 2 i and 2 i + 1. All leaves are on one level, and
     * those on each level have equal parts of the rows, so that nothing but the boxes has to be kept. Distances are compared as squares, in the
     * order of arithmetic (x x + y y) + z z, in which that to a box is never more than that to a place in it, to the last bit.</p>
     *
     * @private
     */
    public final class PlaceTree
    {
        /** Rows in a leaf, at most. */
        private static const LEAF_SIZE:int = 24;

        // How a box and a sphere are to each other.
        private static const APART:int = 0;
        private static const CROSSING:int = 1;
        private static const WITHIN:int = 2;

        /** Numbers of a box: the least x, y, z, then the greatest. */
        internal static const PER_BOX:int = 6;

        /** The number of the first leaf; there are as many leaves. */
        public var firstLeaf:int = 1;

        /** How many rows there are. */
        public var count:int = 0;

        /** The rows in the order of the leaves, as numbers of the list they were given in. */
        public var members:Vector.<int> = new Vector.<int>();

        /** The place that a search is about; fields, because V8 makes an object of each Number that it passes. */
        public var x:Number = 0;

        /** @copy #x */
        public var y:Number = 0;

        /** @copy #x */
        public var z:Number = 0;

        /** The square of the greatest distance that counts. */
        public var limit:Number = Infinity;

        /** A row that does not count in any search, as a number of the list; or -1. */
        public var skipped:int = -1;

        /** The square of the distance beyond which rows count for <code>findNearest</code>; -1 for all. */
        public var beyond:Number = -1;

        /** For <code>keepInCone</code>: the angle between a cone's axis and its border, in degrees below 180. */
        public var coneAngle:Number = 0;

        /** What the last search of several has found, as numbers of the list. */
        public var found:Vector.<int> = new Vector.<int>();

        /** The squared distances of these. */
        public var squares:Vector.<Number> = new Vector.<Number>();

        // In the order of the leaves.
        private var _x:Vector.<Number> = new Vector.<Number>();
        private var _y:Vector.<Number> = new Vector.<Number>();
        private var _z:Vector.<Number> = new Vector.<Number>();

        // By number of the list: where it is in the order of the leaves.
        private var _order:Vector.<int> = new Vector.<int>();

        // By leaf: where its rows begin; behind the last one, where they end.
        private var _starts:Vector.<int> = new Vector.<int>();

        private var _boxes:Vector.<Number> = new Vector.<Number>();

        // Nodes that are to be visited yet, and their squared distances.
        private var _nodes:Vector.<int> = new Vector.<int>();
        private var _squares:Vector.<Number> = new Vector.<Number>();

        // Sine and cosine of an angle: of the last cone's.
        private var _borderAngle:Number = 0;
        private var _sine:Number = 0;
        private var _cosine:Number = 1;

        /** An empty tree. */
        public function PlaceTree()
        {
        }

        /**
         * Makes the tree anew.
         *
         * @param fromX where each row is
         * @param fromY likewise
         * @param fromZ likewise
         * @param rows the list: the rows that count
         * @param rowCount how many of them
         */
        public function build(fromX:Vector.<Number>, fromY:Vector.<Number>, fromZ:Vector.<Number>, rows:Vector.<int>, rowCount:int):void
        {
            count = rowCount;
            firstLeaf = 1;
            while (firstLeaf * LEAF_SIZE < count)
            {
                firstLeaf *= 2;
            }
            grow();
            for (var i:int = 0; i < count; i++)
            {
                var row:int = rows[i];
                members[i] = i;
                _x[i] = fromX[row];
                _y[i] = fromY[row];
                _z[i] = fromZ[row];
            }
            for (i = 0; i <= firstLeaf; i++)
            {
                _starts[i] = i * count / firstLeaf;
            }
            divideAll();
            for (i = 0; i < count; i++)
            {
                _order[members[i]] = i;
            }
            boundLeaves();
            boundNodes();
        }

        /** Where a leaf's rows begin in the order of the leaves; they end where those of the next begin. */
        public function startOf(leaf:int):int
        {
            return _starts[leaf - firstLeaf];
        }

        /** The leaf that has a place in the order of the leaves. */
        public function leafOf(at:int):int
        {
            return firstLeaf + int(((at + 1) * firstLeaf - 1) / count);
        }

        /** The place in the order of the leaves of a row, given as a number of the list. */
        public function orderOf(member:int):int
        {
            return _order[member];
        }

        /** The squared distance from x, y, z of a row, given as a number of the list. */
        public function squareOf(member:int):Number
        {
            return squareAt(_order[member]);
        }

        /**
         * Takes the place of one row anew: the boxes about it grow, so that the tree is right, if not as good as one made anew.
         *
         * @param member its number in the list; it is at x, y, z now
         */
        public function move(member:int):void
        {
            var at:int = _order[member];
            _x[at] = x;
            _y[at] = y;
            _z[at] = z;
            for (var node:int = leafOf(at); node > 0; node >>= 1)
            {
                widen(PER_BOX * node, at);
            }
        }

        /**
         * Finds the row that is nearest to x, y, z, within the limit; of several the one that comes first in the list.
         *
         * @param test says which count; null for all
         * @return its number in the list, or -1
         */
        public function findNearest(test:RowTest):int
        {
            var atX:Number = x;
            var atY:Number = y;
            var atZ:Number = z;
            var xs:Vector.<Number> = _x;
            var ys:Vector.<Number> = _y;
            var zs:Vector.<Number> = _z;
            var nodes:Vector.<int> = _nodes;
            var nodeSquares:Vector.<Number> = _squares;
            var nearest:int = -1;
            var least:Number = limit;
            var waiting:int = skipped < 0 ? begin() : beginBeside(skipped);
            while (waiting > 0)
            {
                waiting--;
                var node:int = nodes[waiting];
                if (nodeSquares[waiting] > least)
                {
                    continue;
                }
                if (node < firstLeaf)
                {
                    // the nearer child is the next
                    var child:int = node << 1;
                    var top:int = waiting + 1;
                    measure(child, waiting);
                    measure(child + 1, top);
                    nodes[waiting] = child;
                    nodes[top] = child + 1;
                    if (nodeSquares[waiting] < nodeSquares[top])
                    {
                        var nearSquare:Number = nodeSquares[waiting];
                        nodeSquares[waiting] = nodeSquares[top];
                        nodeSquares[top] = nearSquare;
                        nodes[waiting] = child + 1;
                        nodes[top] = child;
                    }
                    waiting += 2;
                    continue;
                }
                var end:int = startOf(node + 1);
                for (var at:int = startOf(node); at < end; at++)
                {
                    var toX:Number = xs[at] - atX;
                    var toY:Number = ys[at] - atY;
                    var toZ:Number = zs[at] - atZ;
                    var square:Number = toX * toX + toY * toY + toZ * toZ;
                    if (square > least)
                    {
                        continue;
                    }
                    var member:int = members[at];
                    if ((square == least && nearest >= 0 && member > nearest) || member == skipped || square <= beyond)
                    {
                        continue;
                    }
                    if (test == null || test.accepts(member))
                    {
                        nearest = member;
                        least = square;
                    }
                }
            }
            return nearest;
        }

        /**
         * Finds all rows within the limit of x, y, z: <code>found</code> and <code>squares</code>, in no order.
         *
         * @param test says which count; null for all
         * @return how many
         */
        public function findNear(test:RowTest):int
        {
            var atX:Number = x;
            var atY:Number = y;
            var atZ:Number = z;
            var xs:Vector.<Number> = _x;
            var ys:Vector.<Number> = _y;
            var zs:Vector.<Number> = _z;
            var greatest:Number = limit;
            var length:int = 0;
            var waiting:int = begin();
            while (waiting > 0)
            {
                waiting--;
                var node:int = _nodes[waiting];
                if (relationTo(node) == APART)
                {
                    continue;
                }
                if (node < firstLeaf)
                {
                    _nodes[waiting] = (node << 1) + 1;
                    _nodes[int(waiting + 1)] = node << 1;
                    waiting += 2;
                    continue;
                }
                var end:int = startOf(node + 1);
                for (var at:int = startOf(node); at < end; at++)
                {
                    var toX:Number = xs[at] - atX;
                    var toY:Number = ys[at] - atY;
                    var toZ:Number = zs[at] - atZ;
                    var square:Number = toX * toX + toY * toY + toZ * toZ;
                    if (square <= greatest)
                    {
                        var member:int = members[at];
                        if (member != skipped && (test == null || test.accepts(member)))
                        {
                            found[length] = member;
                            squares[length] = square;
                            length++;
                        }
                    }
                }
            }
            return length;
        }

        /**
         * Counts the rows within the limit of x, y, z.
         *
         * @param test says which count; null for all, and then what is near as a whole is not looked at one by one
         */
        public function countNear(test:RowTest):int
        {
            var atX:Number = x;
            var atY:Number = y;
            var atZ:Number = z;
            var xs:Vector.<Number> = _x;
            var ys:Vector.<Number> = _y;
            var zs:Vector.<Number> = _z;
            var greatest:Number = limit;
            var near:int = 0;
            var waiting:int = begin();
            while (waiting > 0)
            {
                waiting--;
                var node:int = _nodes[waiting];
                var relation:int = relationTo(node);
                if (relation == APART)
                {
                    continue;
                }
                if (relation == WITHIN && test == null)
                {
                    near += countIn(node);
                    continue;
                }
                if (node < firstLeaf)
                {
                    _nodes[waiting] = (node << 1) + 1;
                    _nodes[int(waiting + 1)] = node << 1;
                    waiting += 2;
                    continue;
                }
                var end:int = startOf(node + 1);
                for (var at:int = startOf(node); at < end; at++)
                {
                    var toX:Number = xs[at] - atX;
                    var toY:Number = ys[at] - atY;
                    var toZ:Number = zs[at] - atZ;
                    if (toX * toX + toY * toY + toZ * toZ <= greatest)
                    {
                        if (test == null || (members[at] != skipped && test.accepts(members[at])))
                        {
                            near++;
                        }
                    }
                }
            }
            if (test == null && skipped >= 0 && squareAt(_order[skipped]) <= limit)
            {
                near--;
            }
            return near;
        }

        /**
         * Keeps those rows found that are in a cone whose tip is x, y, z and whose axis is the x axis of a placement; rows at its tip are in it.
         *
         * @param placement its rotation counts
         * @param count how many rows were found
         * @return how many are kept
         */
        public function keepInCone(placement:Placement, count:int):int
        {
            var axisX:Number = placement.r00;
            var axisY:Number = placement.r10;
            var axisZ:Number = placement.r20;
            findBorder();
            var sine:Number = _sine;
            var cosine:Number = _cosine;
            var kept:int = 0;
            for (var i:int = 0; i < count; i++)
            {
                var at:int = _order[found[i]];
                var toX:Number = _x[at] - x;
                var toY:Number = _y[at] - y;
                var toZ:Number = _z[at] - z;
                var acrossX:Number = axisY * toZ - axisZ * toY;
                var acrossY:Number = axisZ * toX - axisX * toZ;
                var acrossZ:Number = axisX * toY - axisY * toX;
                var across:Number = Math.sqrt(acrossX * acrossX + acrossY * acrossY + acrossZ * acrossZ);
                var along:Number = axisX * toX + axisY * toY + axisZ * toZ;
                // the sine of the angle by which it is beyond the border; that of half a turn is 0 too
                if (across * cosine - along * sine > Tolerances.CONE * (across + Math.abs(along)) || (along < 0 && coneAngle < 45))
                {
                    continue;
                }
                found[kept] = found[i];
                squares[kept] = squares[i];
                kept++;
            }
            return kept;
        }

        private function findBorder():void
        {
            if (coneAngle != _borderAngle)
            {
                _sine = Trigonometry.sine(coneAngle);
                _cosine = Trigonometry.cosine(coneAngle);
                _borderAngle = coneAngle;
            }
        }

        // Puts the root on the stack, if there is one; returns how many nodes wait.
        private function begin():int
        {
            _nodes[0] = 1;
            _squares[0] = 0;
            return count > 0 ? 1 : 0;
        }

        // Puts the leaf of a row on the stack, which is likely to have the nearest, and below it all that is beside the way there from the root.
        private function beginBeside(member:int):int
        {
            var leaf:int = leafOf(_order[member]);
            var up:int = 0;
            while (leaf >> up > 1)
            {
                up++;
            }
            var waiting:int = 0;
            while (up > 0)
            {
                up--;
                var node:int = leaf >> up ^ 1;
                measure(node, waiting);
                _nodes[waiting] = node;
                waiting++;
            }
            _nodes[waiting] = leaf;
            _squares[waiting] = 0;
            return waiting + 1;
        }

        private function squareAt(at:int):Number
        {
            var toX:Number = _x[at] - x;
            var toY:Number = _y[at] - y;
            var toZ:Number = _z[at] - z;
            return toX * toX + toY * toY + toZ * toZ;
        }

        // Writes the squared distance to a node's box beside the nodes that wait: returned, V8 would make an object of it.
        private function measure(node:int, slot:int):void
        {
            var boxes:Vector.<Number> = _boxes;
            var box:int = PER_BOX * node;
            var toX:Number = boxes[box] - x;
            if (toX < 0)
            {
                toX = x - boxes[int(box + 3)];
                if (toX < 0)
                {
                    toX = 0;
                }
            }
            var toY:Number = boxes[int(box + 1)] - y;
            if (toY < 0)
            {
                toY = y - boxes[int(box + 4)];
                if (toY < 0)
                {
                    toY = 0;
                }
            }
            var toZ:Number = boxes[int(box + 2)] - z;
            if (toZ < 0)
            {
                toZ = z - boxes[int(box + 5)];
                if (toZ < 0)
                {
                    toZ = 0;
                }
            }
            _squares[slot] = toX * toX + toY * toY + toZ * toZ;
        }

        // Whether a node's box is within the limit of x, y, z: not at all, in parts or as a whole.
        private function relationTo(node:int):int
        {
            var boxes:Vector.<Number> = _boxes;
            var box:int = PER_BOX * node;
            var least:Number = boxes[box] - x;
            var greatest:Number = boxes[int(box + 3)] - x;
            var near:Number = 0;
            var far:Number = greatest;
            if (least > 0)
            {
                near = least;
            }
            else
            {
                if (greatest < 0)
                {
                    near = greatest;
                }
                if (-least > greatest)
                {
                    far = least;
                }
            }
            var nearSquare:Number = near * near;
            var farSquare:Number = far * far;
            least = boxes[int(box + 1)] - y;
            greatest = boxes[int(box + 4)] - y;
            near = 0;
            far = greatest;
            if (least > 0)
            {
                near = least;
            }
            else
            {
                if (greatest < 0)
                {
                    near = greatest;
                }
                if (-least > greatest)
                {
                    far = least;
                }
            }
            nearSquare += near * near;
            farSquare += far * far;
            least = boxes[int(box + 2)] - z;
            greatest = boxes[int(box + 5)] - z;
            near = 0;
            far = greatest;
            if (least > 0)
            {
                near = least;
            }
            else
            {
                if (greatest < 0)
                {
                    near = greatest;
                }
                if (-least > greatest)
                {
                    far = least;
                }
            }
            nearSquare += near * near;
            if (nearSquare > limit)
            {
                return APART;
            }
            farSquare += far * far;
            var relation:int = farSquare <= limit ? WITHIN : CROSSING;
            return relation;
        }

        // How many rows are below a node.
        private function countIn(node:int):int
        {
            var last:int = node;
            while (node < firstLeaf)
            {
                node = node << 1;
                last = (last << 1) + 1;
            }
            return startOf(last + 1) - startOf(node);
        }

        private function grow():void
        {
            if (members.length < count)
            {
                members.length = _order.length = count;
                found.length = squares.length = count;
                _x.length = _y.length = _z.length = count;
            }
            if (_starts.length <= firstLeaf)
            {
                _starts.length = firstLeaf + 1;
            }
            var numbers:int = 2 * firstLeaf * PER_BOX;
            if (_boxes.length < numbers)
            {
                _boxes.length = numbers;
            }
        }

        // Has each node divide its rows in two along the longest side of its part of space, which is written where its box will be.
        private function divideAll():void
        {
            boundRows(1, 0, count);
            var width:int = 1;
            for (var node:int = 1; node < firstLeaf; node++)
            {
                if (node == 2 * width)
                {
                    width = node;
                }
                var box:int = PER_BOX * node;
                var axis:int = longestSide(box);
                var keys:Vector.<Number> = _x;
                if (axis > 0)
                {
                    keys = axis == 1 ? _y : _z;
                }
                var nth:int = node - width;
                var middle:int = (2 * nth + 1) * count / (2 * width);
                select(keys, nth * count / width, (nth + 1) * count / width - 1, middle);
                var child:int = 2 * box;
                for (var i:int = 0; i < PER_BOX; i++)
                {
                    _boxes[child + i] = _boxes[child + PER_BOX + i] = _boxes[box + i];
                }
                _boxes[child + 3 + axis] = _boxes[child + PER_BOX + axis] = keys[middle];
            }
        }

        private function longestSide(box:int):int
        {
            var alongX:Number = _boxes[box + 3] - _boxes[box];
            var alongY:Number = _boxes[box + 4] - _boxes[box + 1];
            var alongZ:Number = _boxes[box + 5] - _boxes[box + 2];
            if (alongX >= alongY && alongX >= alongZ)
            {
                return 0;
            }
            return alongY >= alongZ ? 1 : 2;
        }

        // Moves rows so that none before the middle has a greater key than it, and none after it a smaller one (Hoare, "Find", 1961).
        private function select(keys:Vector.<Number>, first:int, last:int, middle:int):void
        {
            while (first < last)
            {
                var pivot:Number = medianOf(keys[first], keys[(first + last) >> 1], keys[last]);
                var low:int = first;
                var high:int = last;
                while (low <= high)
                {
                    while (keys[low] < pivot)
                    {
                        low++;
                    }
                    while (keys[high] > pivot)
                    {
                        high--;
                    }
                    if (low <= high)
                    {
                        swap(low, high);
                        low++;
                        high--;
                    }
                }
                if (middle <= high)
                {
                    last = high;
                }
                else if (middle >= low)
                {
                    first = low;
                }
                else
                {
                    return;
                }
            }
        }

        private static function medianOf(a:Number, b:Number, c:Number):Number
        {
            if (a > b)
            {
                var swapped:Number = a;
                a = b;
                b = swapped;
            }
            if (c < a)
            {
                return a;
            }
            return c < b ? c : b;
        }

        private function swap(a:int, b:int):void
        {
            var member:int = members[a];
            members[a] = members[b];
            members[b] = member;
            var key:Number = _x[a];
            _x[a] = _x[b];
            _x[b] = key;
            key = _y[a];
            _y[a] = _y[b];
            _y[b] = key;
            key = _z[a];
            _z[a] = _z[b];
            _z[b] = key;
        }

        private function boundLeaves():void
        {
            for (var i:int = 0; i < firstLeaf; i++)
            {
                boundRows(firstLeaf + i, _starts[i], _starts[i + 1]);
            }
        }

        private function boundRows(node:int, start:int, end:int):void
        {
            var box:int = PER_BOX * node;
            for (var side:int = 0; side < 3; side++)
            {
                _boxes[box + side] = Infinity;
                _boxes[box + 3 + side] = -Infinity;
            }
            for (var at:int = start; at < end; at++)
            {
                widen(box, at);
            }
        }

        // Makes a box contain the place of a row.
        private function widen(box:int, at:int):void
        {
            var placeX:Number = _x[at];
            var placeY:Number = _y[at];
            var placeZ:Number = _z[at];
            if (placeX < _boxes[box])
            {
                _boxes[box] = placeX;
            }
            if (placeY < _boxes[int(box + 1)])
            {
                _boxes[int(box + 1)] = placeY;
            }
            if (placeZ < _boxes[int(box + 2)])
            {
                _boxes[int(box + 2)] = placeZ;
            }
            if (placeX > _boxes[int(box + 3)])
            {
                _boxes[int(box + 3)] = placeX;
            }
            if (placeY > _boxes[int(box + 4)])
            {
                _boxes[int(box + 4)] = placeY;
            }
            if (placeZ > _boxes[int(box + 5)])
            {
                _boxes[int(box + 5)] = placeZ;
            }
        }

        // Makes each node's box contain those of its children.
        private function boundNodes():void
        {
            for (var box:int = PER_BOX * (firstLeaf - 1); box > 0; box -= PER_BOX)
            {
                var child:int = 2 * box;
                for (var side:int = 0; side < 3; side++)
                {
                    _boxes[box + side] = Math.min(_boxes[child + side], _boxes[child + PER_BOX + side]);
                    _boxes[box + 3 + side] = Math.max(_boxes[child + 3 + side], _boxes[child + PER_BOX + 3 + side]);
                }
            }
        }
    }
}
