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
         * @param rows the rows, which come into the order of the leaves
         * @param count how many they are
         * @param points by row: the middle of the row's box
         * @param boxes by node: receives its part of space
         * @param firstLeaf the node number of the first leaf
         */
        public static function divide(rows:Vector.<int>, count:int, points:Points, boxes:Vector.<Number>, firstLeaf:int):void
        {
            for (var side:int = 0; side < 3; side++)
            {
                boundRoot(rows, count, columnOf(points, side), boxes, RowTree.PER_BOX * RowTree.ROOT + side);
            }
            var width:int = 1;
            for (var node:int = RowTree.ROOT; node < firstLeaf; node++)
            {
                if (node == 2 * width)
                {
                    width = node;
                }
                var box:int = RowTree.PER_BOX * node;
                var axis:int = longestSide(boxes, box);
                var keys:Vector.<Number> = columnOf(points, axis);
                var nth:int = node - width;
                var middle:int = (2 * nth + 1) * count / (2 * width);
                select(rows, keys, nth * count / width, (nth + 1) * count / width - 1, middle);
                var child:int = 2 * box;
                for (var i:int = 0; i < RowTree.PER_BOX; i++)
                {
                    boxes[child + i] = boxes[child + RowTree.PER_BOX + i] = boxes[box + i];
                }
                boxes[child + 3 + axis] = boxes[child + RowTree.PER_BOX + axis] = keys[rows[middle]];
            }
        }

        private static function columnOf(points:Points, axis:int):Vector.<Number>
        {
            return axis == 0 ? points.x : (axis == 1 ? points.y : points.z);
        }

        private static function boundRoot(rows:Vector.<int>, count:int, keys:Vector.<Number>, boxes:Vector.<Number>, side:int):void
        {
            var least:Number = Infinity;
            var greatest:Number = -Infinity;
            for (var i:int = 0; i < count; i++)
            {
                var key:Number = keys[rows[i]];
                least = key < least ? key : least;
                greatest = key > greatest ? key : greatest;
            }
            boxes[side] = least;
            boxes[side + 3] = greatest;
        }

        private static function longestSide(boxes:Vector.<Number>, box:int):int
        {
            var longest:int = 0;
            for (var side:int = 1; side < 3; side++)
            {
                if (boxes[box + 3 + side] - boxes[box + side] > boxes[box + 3 + longest] - boxes[box + longest])
                {
                    longest = side;
                }
            }
            return longest;
        }

        // Sorts rows partly: the keys before the middle are not greater than the middle's key, the keys after it not smaller (quickselect: Hoare,
        // "Find", 1961).
        private static function select(rows:Vector.<int>, keys:Vector.<Number>, first:int, last:int, middle:int):void
        {
            while (first < last)
            {
                // the median of three
                var one:Number = keys[rows[first]];
                var other:Number = keys[rows[last]];
                var pivot:Number = Math.max(Math.min(one, other), Math.min(Math.max(one, other), keys[rows[(first + last) >> 1]]));
                var low:int = first;
                var high:int = last;
                while (low <= high)
                {
                    while (keys[rows[low]] < pivot)
                    {
                        low++;
                    }
                    while (keys[rows[high]] > pivot)
                    {
                        high--;
                    }
                    if (low <= high)
                    {
                        var row:int = rows[low];
                        rows[low] = rows[high];
                        rows[high] = row;
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
    }
}
