package starlogo.hierarchy
{
    import starlogo.engine;

    use namespace engine;

    /**
     * The items of a tree while it is made: its triangles or its vertices. Divides the items of a node in two, and changes
     * their order so that the items of each node stand side by side.
     *
     * @private
     */
    public final class TreeItems
    {
        /** The extents of all items together after <code>measure()</code>. */
        public var bounds:Vector.<Number> = new <Number>[Infinity, -Infinity, Infinity, -Infinity, Infinity, -Infinity];

        /** After a division, the slot at which the second group begins. */
        public var middle:int;

        /** The extents of the first group of the last division. */
        public var leftExtents:Vector.<Number> = new Vector.<Number>(6, true);

        /** The extents of the second group of the last division. */
        public var rightExtents:Vector.<Number> = new Vector.<Number>(6, true);

        /** The axis of the last division: 0, 1 or 2. */
        public var axis:int;

        private var _tree:BoxTree;

        // The extents of each item, by its index: minX, maxX, minY, maxY, minZ, maxZ.
        private var _extents:Vector.<Number>;

        // The current division. The last item not looked at yet is at _last. The first one is at middle + _waiting, because the item at the
        // middle may wait to be put last.
        private var _last:int;
        private var _waiting:int;
        private var _split:Number;

        /**
         * @param tree has the items; receives their order, which begins as that of their indices
         */
        public function TreeItems(tree:BoxTree)
        {
            _tree = tree;
            tree.items = new Vector.<int>(tree.itemCount, true);
            for (var i:int = 0; i < tree.items.length; i++)
            {
                tree.items[i] = i;
            }
        }

        /** Measures a range of items. Must be called for all items before other methods. */
        public function measure(first:int, end:int):void
        {
            _extents ||= new Vector.<Number>(6 * _tree.items.length, true);
            for (var i:int = first; i < end; i++)
            {
                // the order is still that of the indices
                _tree.writeExtents(i, i + 1, _extents, 6 * i);
                for (var k:int = 0; k < 6; k += 2)
                {
                    var low:Number = _extents[int(6 * i + k)];
                    var high:Number = _extents[int(6 * i + k + 1)];
                    bounds[k] = low < bounds[k] ? low : bounds[k];
                    bounds[k + 1] = high > bounds[k + 1] ? high : bounds[k + 1];
                }
            }
        }

        /** Twice the mean of the centres of some items along an axis. */
        public function meanOf(first:int, end:int, axis:int):Number
        {
            var sum:Number = 0;
            for (var i:int = first; i < end; i++)
            {
                sum += sumAlong(axis, i);
            }
            return sum / (end - first);
        }

        /**
         * Begins a division: the items whose centre is below a splitting point move before the others. The extents of both groups are
         * computed at the same time, so that an item is read once for each level.
         *
         * @param first the slot of the first item
         * @param end the slot after the last item
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
         * @param first the slot of the first item
         * @param end the slot after the last item
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
                for (var i:int = first; i < end; i++)
                {
                    var sum:Number = sumAlong(along, i);
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
            var items:Vector.<int> = _tree.items;
            var all:Vector.<Number> = _extents;
            var along:int = axis;
            var split:Number = _split;
            var i:int = middle;
            var last:int = _last;
            var waiting:int = _waiting;
            var rest:int = last - i - waiting + 1 - most;
            rest = rest < 0 ? 0 : rest;
            var leftMinX:Number = leftExtents[0];
            var leftMinY:Number = leftExtents[2];
            var leftMinZ:Number = leftExtents[4];
            var leftMaxX:Number = leftExtents[1];
            var leftMaxY:Number = leftExtents[3];
            var leftMaxZ:Number = leftExtents[5];
            var rightMinX:Number = rightExtents[0];
            var rightMinY:Number = rightExtents[2];
            var rightMinZ:Number = rightExtents[4];
            var rightMaxX:Number = rightExtents[1];
            var rightMaxY:Number = rightExtents[3];
            var rightMaxZ:Number = rightExtents[5];
            while (last - i - waiting >= rest)
            {
                var item:int = items[waiting == 0 ? i : last];
                var at:int = 6 * item;
                var minX:Number = all[at];
                var minY:Number = all[int(at + 2)];
                var minZ:Number = all[int(at + 4)];
                var maxX:Number = all[int(at + 1)];
                var maxY:Number = all[int(at + 3)];
                var maxZ:Number = all[int(at + 5)];
                var sum:Number = along == 0 ? minX + maxX : (along == 1 ? minY + maxY : minZ + maxZ);
                if (sum < split)
                {
                    if (waiting == 1)
                    {
                        items[last] = items[i];
                        items[i] = item;
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
            return rest > 0;
        }

        // Twice the centre of the extents of the item in a slot, along an axis.
        private function sumAlong(axis:int, slot:int):Number
        {
            var at:int = 6 * _tree.items[slot] + 2 * axis;
            return _extents[at] + _extents[int(at + 1)];
        }

        private static function write(extents:Vector.<Number>, minX:Number, minY:Number, minZ:Number,
                maxX:Number, maxY:Number, maxZ:Number):void
        {
            extents[0] = minX;
            extents[1] = maxX;
            extents[2] = minY;
            extents[3] = maxY;
            extents[4] = minZ;
            extents[5] = maxZ;
        }
    }
}
