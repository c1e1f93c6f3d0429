package starlogo.hierarchy
{
    /**
     * The items of a hierarchy: its triangles or its vertices. Keeps an order in which the items of each node stand side by side, and their
     * extents in this order. Divides the items of a node in two.
     *
     * @private
     */
    public final class TreeItems
    {
        /** The indices of the items. */
        public var order:Vector.<int>;

        /** The number of items. */
        public var count:int;

        /** The extents of each item, in the order of the items: minX, minY, minZ, maxX, maxY, maxZ. */
        public var extents:Vector.<Number>;

        /** The extents of all items together after <code>measure()</code>. */
        public var bounds:Vector.<Number> = new <Number>[Infinity, Infinity, Infinity, -Infinity, -Infinity, -Infinity];

        /** After a division, the index in the order at which the second group begins. */
        public var middle:int;

        /** The extents of the first group of the last division. */
        public var leftExtents:Vector.<Number> = new Vector.<Number>(6, true);

        /** The extents of the second group of the last division. */
        public var rightExtents:Vector.<Number> = new Vector.<Number>(6, true);

        /** The axis of the last division: 0, 1 or 2. */
        public var axis:int;

        private var _vertices:Vector.<Number>;
        private var _triangles:Vector.<uint>;

        private var _isOrdered:Boolean;

        // The current division. The last item not looked at yet is at _last. The first one is at middle + _waiting, because the item at the
        // middle may wait to be put last.
        private var _last:int;
        private var _waiting:int;
        private var _split:Number;

        /**
         * @param vertices x, y, z of each
         * @param triangles three vertex indices each, or null if the vertices are the items
         * @param order an order that the items already have; null for the order of their indices
         */
        public function TreeItems(vertices:Vector.<Number>, triangles:Vector.<uint>, order:Vector.<int> = null)
        {
            _vertices = vertices;
            _triangles = triangles;
            count = (triangles == null ? vertices.length : triangles.length) / 3;
            _isOrdered = order != null;
            this.order = _isOrdered ? order : new Vector.<int>(count, true);
        }

        /** Measures a range of items. Must be called for all items before other methods. */
        public function measure(first:int, end:int):void
        {
            extents ||= new Vector.<Number>(6 * count, true);
            for (var i:int = first; i < end; i++)
            {
                if (!_isOrdered)
                {
                    order[i] = i;
                }
                writeExtents(_vertices, _triangles, order[i], extents, 6 * i);
            }
            extend(bounds, 6 * first, 6 * end);
        }

        /** Writes the extents of a range of items together. */
        public function writeBounds(first:int, end:int, out:Vector.<Number>):void
        {
            write(out, Infinity, Infinity, Infinity, -Infinity, -Infinity, -Infinity);
            extend(out, 6 * first, 6 * end);
        }

        /** Adds the smallest and largest coordinates of a range of items along an axis to a number, one after the other. Returns the sum. */
        public function sumOf(sum:Number, first:int, end:int, axis:int):Number
        {
            for (var at:int = 6 * first + axis; at < 6 * end; at += 6)
            {
                sum += extents[at] + extents[int(at + 3)];
            }
            return sum;
        }

        /**
         * Begins a division: the items whose centre is below a splitting point move before the others. The extents of both groups are
         * computed at the same time, so that an item is read once for each level.
         *
         * @param first index of the first item in the order
         * @param end index after the last item
         * @param axis 0, 1 or 2
         * @param split twice the coordinate of the splitting point
         */
        public function beginDivision(first:int, end:int, axis:int, split:Number):void
        {
            middle = first;
            _last = end - 1;
            _waiting = 0;
            this.axis = axis;
            _split = split;
            write(leftExtents, Infinity, Infinity, Infinity, -Infinity, -Infinity, -Infinity);
            write(rightExtents, Infinity, Infinity, Infinity, -Infinity, -Infinity, -Infinity);
        }

        /**
         * Begins a division at the midpoint of the axis along which the centres of some items are spread most.
         *
         * @param first index of the first item in the order
         * @param end index after the last item
         * @return false if all centres are in one place, because then no division is possible
         */
        public function beginWhereCentresSpread(first:int, end:int):Boolean
        {
            var widest:int = 0;
            var width:Number = 0;
            var split:Number = 0;
            for (var along:int = 0; along < 3; along++)
            {
                // twice the smallest and the largest centre
                var least:Number = Infinity;
                var largest:Number = -Infinity;
                for (var at:int = 6 * first + along; at < 6 * end; at += 6)
                {
                    var sum:Number = extents[at] + extents[int(at + 3)];
                    least = sum < least ? sum : least;
                    largest = sum > largest ? sum : largest;
                }
                if (largest - least > width)
                {
                    widest = along;
                    width = largest - least;
                    split = least + 0.5 * width;
                }
            }
            beginDivision(first, end, widest, split);
            return width > 0;
        }

        /**
         * Continues the division. The steps for an item are: its extents, the side of the splitting point on which its centre is, its
         * place, and the extents of its group, which are kept in locals. The first item on the wrong side waits until the last item on the
         * wrong side is found. Then the two change places. So items that are divided already keep their places.
         *
         * @param most the largest number of items to look at
         * @return whether there are more items
         */
        public function divideSome(most:int):Boolean
        {
            var items:Vector.<int> = order;
            var all:Vector.<Number> = extents;
            var along:int = axis;
            var split:Number = _split;
            var i:int = middle;
            var last:int = _last;
            var waiting:int = _waiting;
            var left:int = last - i - waiting + 1 - most;
            left = left < 0 ? 0 : left;
            var leftMinX:Number = leftExtents[0];
            var leftMinY:Number = leftExtents[1];
            var leftMinZ:Number = leftExtents[2];
            var leftMaxX:Number = leftExtents[3];
            var leftMaxY:Number = leftExtents[4];
            var leftMaxZ:Number = leftExtents[5];
            var rightMinX:Number = rightExtents[0];
            var rightMinY:Number = rightExtents[1];
            var rightMinZ:Number = rightExtents[2];
            var rightMaxX:Number = rightExtents[3];
            var rightMaxY:Number = rightExtents[4];
            var rightMaxZ:Number = rightExtents[5];
            while (last - i - waiting >= left)
            {
                var at:int = 6 * (waiting == 0 ? i : last);
                var minX:Number = all[at];
                var minY:Number = all[int(at + 1)];
                var minZ:Number = all[int(at + 2)];
                var maxX:Number = all[int(at + 3)];
                var maxY:Number = all[int(at + 4)];
                var maxZ:Number = all[int(at + 5)];
                var sum:Number = along == 0 ? minX + maxX : (along == 1 ? minY + maxY : minZ + maxZ);
                if (sum < split)
                {
                    if (waiting == 1)
                    {
                        var item:int = items[last];
                        items[last] = items[i];
                        items[i] = item;
                        var to:int = 6 * i;
                        all[at] = all[to];
                        all[int(at + 1)] = all[int(to + 1)];
                        all[int(at + 2)] = all[int(to + 2)];
                        all[int(at + 3)] = all[int(to + 3)];
                        all[int(at + 4)] = all[int(to + 4)];
                        all[int(at + 5)] = all[int(to + 5)];
                        all[to] = minX;
                        all[int(to + 1)] = minY;
                        all[int(to + 2)] = minZ;
                        all[int(to + 3)] = maxX;
                        all[int(to + 4)] = maxY;
                        all[int(to + 5)] = maxZ;
                        last--;
                        waiting = 0;
                    }
                    i++;
                    leftMinX = minX < leftMinX ? minX : leftMinX;
                    leftMaxX = maxX > leftMaxX ? maxX : leftMaxX;
                    leftMinY = minY < leftMinY ? minY : leftMinY;
                    leftMaxY = maxY > leftMaxY ? maxY : leftMaxY;
                    leftMinZ = minZ < leftMinZ ? minZ : leftMinZ;
                    leftMaxZ = maxZ > leftMaxZ ? maxZ : leftMaxZ;
                }
                else
                {
                    last -= waiting;
                    waiting = 1;
                    rightMinX = minX < rightMinX ? minX : rightMinX;
                    rightMaxX = maxX > rightMaxX ? maxX : rightMaxX;
                    rightMinY = minY < rightMinY ? minY : rightMinY;
                    rightMaxY = maxY > rightMaxY ? maxY : rightMaxY;
                    rightMinZ = minZ < rightMinZ ? minZ : rightMinZ;
                    rightMaxZ = maxZ > rightMaxZ ? maxZ : rightMaxZ;
                }
            }
            write(leftExtents, leftMinX, leftMinY, leftMinZ, leftMaxX, leftMaxY, leftMaxZ);
            write(rightExtents, rightMinX, rightMinY, rightMinZ, rightMaxX, rightMaxY, rightMaxZ);
            middle = i;
            _last = last;
            _waiting = waiting;
            return left > 0;
        }

        /**
         * Writes an item's extents: minX, minY, minZ, maxX, maxY, maxZ.
         *
         * @param vertices x, y, z of each
         * @param triangles three vertex indices each, or null if the vertices are the items
         * @param item the index of the item
         * @param out receives the extents
         * @param at index in out at which they begin
         */
        public static function writeExtents(vertices:Vector.<Number>, triangles:Vector.<uint>, item:int, out:Vector.<Number>, at:int):void
        {
            var a:int = 3 * item;
            var b:int = a;
            var c:int = a;
            if (triangles != null)
            {
                a = 3 * triangles[int(3 * item)];
                b = 3 * triangles[int(3 * item + 1)];
                c = 3 * triangles[int(3 * item + 2)];
            }
            for (var end:int = at + 3; at < end; at++)
            {
                var p:Number = vertices[a++];
                var q:Number = vertices[b++];
                var r:Number = vertices[c++];
                var low:Number = q < p ? q : p;
                var high:Number = q < p ? p : q;
                out[at] = r < low ? r : low;
                out[int(at + 3)] = r > high ? r : high;
            }
        }

        // Extends bounds by a range of the items' extents.
        private function extend(bounds:Vector.<Number>, from:int, to:int):void
        {
            for (var along:int = 0; along < 3; along++)
            {
                var least:Number = bounds[along];
                var largest:Number = bounds[along + 3];
                for (var i:int = from + along; i < to; i += 6)
                {
                    var coordinate:Number = extents[i];
                    least = coordinate < least ? coordinate : least;
                    coordinate = extents[int(i + 3)];
                    largest = coordinate > largest ? coordinate : largest;
                }
                bounds[along] = least;
                bounds[along + 3] = largest;
            }
        }

        private static function write(extents:Vector.<Number>, minX:Number, minY:Number, minZ:Number,
                maxX:Number, maxY:Number, maxZ:Number):void
        {
            extents[0] = minX;
            extents[1] = minY;
            extents[2] = minZ;
            extents[3] = maxX;
            extents[4] = maxY;
            extents[5] = maxZ;
        }
    }
}
