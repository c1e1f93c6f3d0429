package starlogo.search
{
    /**
     * Sorts things by keys, smallest first. Things with equal keys are sorted by their ranks. Things with equal keys and ranks keep their order.
     *
     * <p>It is a merge sort. It begins with short runs, which it sorts by insertion.</p>
     *
     * @private
     */
    public final class KeySort
    {
        private static const RUN:int = 8;

        private var _otherThings:Vector.<int> = new Vector.<int>();
        private var _otherKeys:Vector.<Number> = new Vector.<Number>();

        /**
         * Sorts things.
         *
         * @param things the number of each thing
         * @param keys the key of each thing; sorted together with the things
         * @param count how many things to sort
         * @param ranks the rank of each thing, by the thing's number; null if there are no ranks
         */
        public function sort(things:Vector.<int>, keys:Vector.<Number>, count:int, ranks:Vector.<int> = null):void
        {
            for (var low:int = 0; low < count; low += RUN)
            {
                insert(things, keys, ranks, low, low + RUN < count ? low + RUN : count);
            }
            if (count <= RUN)
            {
                return;
            }
            if (_otherThings.length < things.length)
            {
                _otherThings.length = _otherKeys.length = things.length;
            }
            var from:Vector.<int> = things;
            var fromKeys:Vector.<Number> = keys;
            var to:Vector.<int> = _otherThings;
            var toKeys:Vector.<Number> = _otherKeys;
            for (var width:int = RUN; width < count; width *= 2)
            {
                for (low = 0; low < count; low += 2 * width)
                {
                    var middle:int = low + width < count ? low + width : count;
                    merge(from, fromKeys, to, toKeys, ranks, low, middle, middle + width < count ? middle + width : count);
                }
                var merged:Vector.<int> = to;
                var mergedKeys:Vector.<Number> = toKeys;
                to = from;
                toKeys = fromKeys;
                from = merged;
                fromKeys = mergedKeys;
            }
            for (var i:int = 0; from !== things && i < count; i++)
            {
                things[i] = from[i];
                keys[i] = fromKeys[i];
            }
        }

        private static function insert(things:Vector.<int>, keys:Vector.<Number>, ranks:Vector.<int>, low:int, high:int):void
        {
            for (var i:int = low + 1; i < high; i++)
            {
                var thing:int = things[i];
                var key:Number = keys[i];
                var at:int = i - 1;
                while (at >= low && (keys[at] > key || (keys[at] == key && ranks != null && ranks[things[at]] > ranks[thing])))
                {
                    keys[int(at + 1)] = keys[at];
                    things[int(at + 1)] = things[at];
                    at--;
                }
                keys[int(at + 1)] = key;
                things[int(at + 1)] = thing;
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
