package starlogo.search
{
    /** Orders things by their times; those of one time stay as they are (merge sort, from runs that are in order already). */
    internal final class TimeOrder
    {
        /** The numbers of the things, from 0, in their order. */
        public var order:Vector.<int> = new Vector.<int>();

        private var _merged:Vector.<int> = new Vector.<int>();

        /** Nothing ordered yet. */
        public function TimeOrder()
        {
        }

        /**
         * Finds the order.
         *
         * @param times of each
         * @param count how many there are
         */
        public function sort(times:Vector.<Number>, count:int):void
        {
            var isOrdered:Boolean = true;
            for (var i:int = 0; i < count; i++)
            {
                order[i] = _merged[i] = i;
                if (i > 0 && times[i] < times[int(i - 1)])
                {
                    isOrdered = false;
                }
            }
            for (var width:int = 1; width < count && !isOrdered; width *= 2)
            {
                for (var low:int = 0; low < count; low += 2 * width)
                {
                    merge(times, low, Math.min(low + width, count), Math.min(low + 2 * width, count));
                }
                var swapped:Vector.<int> = order;
                order = _merged;
                _merged = swapped;
            }
        }

        private function merge(times:Vector.<Number>, low:int, middle:int, high:int):void
        {
            var from:Vector.<int> = order;
            var to:Vector.<int> = _merged;
            var left:int = low;
            var right:int = middle;
            for (var i:int = low; i < high; i++)
            {
                if (left < middle && (right >= high || times[from[left]] <= times[from[right]]))
                {
                    to[i] = from[left];
                    left++;
                }
                else
                {
                    to[i] = from[right];
                    right++;
                }
            }
        }
    }
}
