package starlogo.queries.trees
{
    import starlogo.broadphase.Points;

    /**
     * Brings the rows of a RowTree into the order of its leaves.
     *
     * @private
     */
    public final class RowDivision
    {
        /**
         * Divides the rows of each node in two halves, along the longest side of the node's part of space.
         *
         * @param rows by slot: the row. They come into the order of the leaves
         * @param middles by slot: the middle of the row's box, in the same order
         * @param boxes by node: room for its part of space. The root's has to contain all middles
         * @param count the number of rows
         * @param firstLeaf the node number of the first leaf
         */
        public static function divide(rows:Vector.<int>, middles:Points, boxes:Vector.<Number>, count:int, firstLeaf:int):void
        {
            var width:int = 1;
            for (var node:int = RowTree.ROOT; node < firstLeaf; node++)
            {
                if (node == 2 * width)
                {
                    width = node;
                }
                var box:int = RowTree.PER_BOX * node;
                var axis:int = longestSide(boxes, box);
                var keys:Vector.<Number> = axis == 0 ? middles.x : (axis == 1 ? middles.y : middles.z);
                var nth:int = node - width;
                var middle:int = (2 * nth + 1) * count / (2 * width);
                select(rows, middles, keys, nth * count / width, (nth + 1) * count / width - 1, middle);
                var child:int = 2 * box;
                for (var i:int = 0; i < RowTree.PER_BOX; i++)
                {
                    boxes[child + i] = boxes[child + RowTree.PER_BOX + i] = boxes[box + i];
                }
                boxes[child + 3 + axis] = boxes[child + RowTree.PER_BOX + axis] = keys[middle];
            }
        }

        private static function longestSide(boxes:Vector.<Number>, box:int):int
        {
            var alongX:Number = boxes[box + 3] - boxes[box];
            var alongY:Number = boxes[box + 4] - boxes[box + 1];
            var alongZ:Number = boxes[box + 5] - boxes[box + 2];
            if (alongX >= alongY && alongX >= alongZ)
            {
                return 0;
            }
            return alongY >= alongZ ? 1 : 2;
        }

        // Sorts rows partly: the keys before the middle are not greater than the middle's key, the keys after it not smaller (Hoare, "Find",
        // 1961).
        private static function select(rows:Vector.<int>, middles:Points, keys:Vector.<Number>, first:int, last:int, middle:int):void
        {
            while (first < last)
            {
                // the median of three
                var one:Number = keys[first];
                var other:Number = keys[last];
                var pivot:Number = Math.max(Math.min(one, other), Math.min(Math.max(one, other), keys[(first + last) >> 1]));
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
                        swap(rows, middles, low, high);
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

        private static function swap(rows:Vector.<int>, middles:Points, a:int, b:int):void
        {
            var row:int = rows[a];
            rows[a] = rows[b];
            rows[b] = row;
            var x:Vector.<Number> = middles.x;
            var y:Vector.<Number> = middles.y;
            var z:Vector.<Number> = middles.z;
            var key:Number = x[a];
            x[a] = x[b];
            x[b] = key;
            key = y[a];
            y[a] = y[b];
            y[b] = key;
            key = z[a];
            z[a] = z[b];
            z[b] = key;
        }
    }
}
