package starlogo.data
{
    /**
     * A list of whole numbers, each with a key. It sorts them by their keys, the smallest first. Numbers with equal keys are sorted by their
     * ranks; with equal ranks too, they keep their order. The memory of the list is used again.
     *
     * <p>It is a merge sort. It begins with short runs, which it sorts by insertion.</p>
     *
     * @private
     */
    public final class SortableIntList
    {
        private static const RUN:int = 8;

        /** The values. After the last one, values may be left over from earlier lists. */
        public var values:Vector.<int> = new Vector.<int>();

        /** The key of each number. */
        public var keys:Vector.<Number> = new Vector.<Number>();

        /** How many numbers there are. */
        public var count:int = 0;

        // The other half of a merge.
        private var _otherValues:Vector.<int> = new Vector.<int>();
        private var _otherKeys:Vector.<Number> = new Vector.<Number>();

        /** Adds a number at the end. */
        public function add(value:int, key:Number):void
        {
            values[count] = value;
            keys[count] = key;
            count++;
        }

        /**
         * Sorts the first numbers of the list.
         *
         * @param end how many
         * @param ranks by number: its rank; null if there are no ranks
         */
        public function sortFirst(end:int, ranks:Vector.<int> = null):void
        {
            for (var low:int = 0; low < end; low += RUN)
            {
                sortRun(values, keys, ranks, low, low + RUN < end ? low + RUN : end);
            }
            if (end <= RUN)
            {
                return;
            }
            if (_otherValues.length < values.length)
            {
                _otherValues.length = _otherKeys.length = values.length;
            }
            var from:Vector.<int> = values;
            var fromKeys:Vector.<Number> = keys;
            var to:Vector.<int> = _otherValues;
            var toKeys:Vector.<Number> = _otherKeys;
            for (var width:int = RUN; width < end; width *= 2)
            {
                for (low = 0; low < end; low += 2 * width)
                {
                    var middle:int = low + width < end ? low + width : end;
                    merge(from, fromKeys, to, toKeys, ranks, low, middle, middle + width < end ? middle + width : end);
                }
                var merged:Vector.<int> = to;
                var mergedKeys:Vector.<Number> = toKeys;
                to = from;
                toKeys = fromKeys;
                from = merged;
                fromKeys = mergedKeys;
            }
            for (var i:int = 0; from !== values && i < end; i++)
            {
                values[i] = from[i];
                keys[i] = fromKeys[i];
            }
        }

        private static function sortRun(values:Vector.<int>, keys:Vector.<Number>, ranks:Vector.<int>, low:int, high:int):void
        {
            for (var i:int = low + 1; i < high; i++)
            {
                var value:int = values[i];
                var key:Number = keys[i];
                var at:int = i - 1;
                while (at >= low && (keys[at] > key || (keys[at] == key && ranks != null && ranks[values[at]] > ranks[value])))
                {
                    keys[int(at + 1)] = keys[at];
                    values[int(at + 1)] = values[at];
                    at--;
                }
                keys[int(at + 1)] = key;
                values[int(at + 1)] = value;
            }
        }

        private static function merge(from:Vector.<int>, fromKeys:Vector.<Number>, to:Vector.<int>, toKeys:Vector.<Number>, ranks:Vector.<int>, low:int,
                middle:int, high:int):void
        {
            var left:int = low;
            var right:int = middle;
            for (var i:int = low; i < high; i++)
            {
                var isLeft:Boolean = left < middle;
                if (isLeft && right < high)
                {
                    isLeft = fromKeys[left] < fromKeys[right]
                        || (fromKeys[left] == fromKeys[right] && (ranks == null || ranks[from[left]] <= ranks[from[right]]));
                }
                var next:int = right;
                if (isLeft)
                {
                    next = left;
                    left++;
                }
                else
                {
                    right++;
                }
                to[i] = from[next];
                toKeys[i] = fromKeys[next];
            }
        }
    }
}
