package starlogo.search
{
    /** Puts pairs into the order of their times; those of the same time stay in their order. */
    internal final class TimeOrder
    {
        private var _order:KeyOrder = new KeyOrder();

        // The numbers of the pairs, in their order; and the pairs as they were.
        private var _numbers:Vector.<int> = new Vector.<int>();
        private var _before:Vector.<int> = new Vector.<int>();

        /** Nothing ordered yet. */
        public function TimeOrder()
        {
        }

        /**
         * Orders pairs.
         *
         * @param times of each; they are ordered with the pairs
         * @param pairs two numbers each
         * @param count how many pairs
         */
        public function sort(times:Vector.<Number>, pairs:Vector.<int>, count:int):void
        {
            var isOrdered:Boolean = true;
            for (var i:int = 0; i < count; i++)
            {
                _numbers[i] = i;
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
            _order.sort(_numbers, times, count);
            for (i = 0; i < count; i++)
            {
                pairs[2 * i] = _before[2 * _numbers[i]];
                pairs[2 * i + 1] = _before[2 * _numbers[i] + 1];
            }
        }
    }
}
