package starlogo.search
{
    /** Puts pairs into the order of their times; those of the same time stay in their order (merge sort, from runs that are in order already). */
    internal final class TimeOrder
    {
        // The numbers of the pairs, in their order; and the pairs as they were.
        private var _order:Vector.<int> = new Vector.<int>();
        private var _merged:Vector.<int> = new Vector.<int>();
        private var _before:Vector.<int> = new Vector.<int>();

        /** Nothing ordered yet. */
        public function TimeOrder()
        {
        }

        /**
         * Orders pairs.
         *
         * @param times of each
         * @param pairs two numbers each
         * @param count how many pairs
         */
        public function sort(times:Vector.<Number>, pairs:Vector.<int>, count:int):void
        {
            var isOrdered:Boolean = true;
            for (var i:int = 0; i < count; i++)
            {
                _order[i] = _merged[i] = i;
                _before[2 * i] = pairs[2 * i];
                _before[2 * i + 1] = pairs[2 * i + 1];
                if (i > 0 && times[i] < times[int(i - 1)])
                {
                    isOrdered = false;
                }
            }
            if (isOrdered)
            {
                return;
            }
            for (var width:int = 1; width < count; width *= 2)
            {
                for (var low:int = 0; low < count; low += 2 * width)
                {
                    merge(times, low, Math.min(low + width, count), Math.min(low + 2 * width, count));
                }
                var swapped:Vector.<int> = _order;
                _order = _merged;
                _merged = swapped;
            }
            for (i = 0; i < count; i++)
            {
                pairs[2 * i] = _before[2 * _order[i]];
                pairs[2 * i + 1] = _before[2 * _order[i] + 1];
            }
        }

        private function merge(times:Vector.<Number>, low:int, middle:int, high:int):void
        {
            var from:Vector.<int> = _order;
            var left:int = low;
            var right:int = middle;
            for (var i:int = low; i < high; i++)
            {
                var isLeft:Boolean = left < middle && (right >= high || times[from[left]] <= times[from[right]]);
                _merged[i] = isLeft ? from[left++] : from[right++];
            }
        }
    }
}
