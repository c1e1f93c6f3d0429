package starlogo.diagnostics
{
    /**
     * The mean, the median and the longest of many frames' times. A Flash player measures whole milliseconds, so its median and longest
     * times are whole numbers. Only the mean over many frames is more precise.
     */
    public final class FrameTimes
    {
        private var _times:Vector.<Number> = new Vector.<Number>();
        private var _capacity:int;
        private var _next:int = 0;

        /**
         * Creates an object without times.
         *
         * @param capacity the number of times that are kept; then a new time replaces the oldest
         * @throws RangeError if it is less than 1
         */
        public function FrameTimes(capacity:int = 10000)
        {
            if (capacity < 1)
            {
                throw new RangeError("capacity must be at least 1: " + capacity);
            }
            _capacity = capacity;
        }

        /** The number of times it has. */
        public function get frames():int
        {
            return _times.length;
        }

        /**
         * Adds a frame's time in milliseconds.
         *
         * @throws RangeError if it is negative or not a number
         */
        public function add(milliseconds:Number):void
        {
            if (!(milliseconds >= 0))
            {
                throw new RangeError("milliseconds must be 0 or more, not " + milliseconds);
            }
            _times[_next] = milliseconds;
            _next = _next + 1 == _capacity ? 0 : _next + 1;
        }

        /** Removes all times. */
        public function clear():void
        {
            _times.length = _next = 0;
        }

        /** The mean in milliseconds; 0 without frames. */
        public function get mean():Number
        {
            var sum:Number = 0;
            for each (var time:Number in _times)
            {
                sum += time;
            }
            return _times.length == 0 ? 0 : sum / _times.length;
        }

        /** The median in milliseconds; 0 without frames. It sorts the times, so do not read it every frame. */
        public function get median():Number
        {
            var sorted:Vector.<Number> = _times.concat().sort(Array.NUMERIC);
            var middle:int = sorted.length >> 1;
            if (sorted.length % 2 == 1)
            {
                return sorted[middle];
            }
            return sorted.length == 0 ? 0 : (sorted[middle - 1] + sorted[middle]) / 2;
        }

        /** The longest time in milliseconds; 0 without frames. */
        public function get most():Number
        {
            var longest:Number = 0;
            for each (var time:Number in _times)
            {
                longest = time > longest ? time : longest;
            }
            return longest;
        }

        /** All three in one line: "mean 1.25 ms, median 1.00 ms, most 9.00 ms". */
        public function toString():String
        {
            return "mean " + mean.toFixed(2) + " ms, median " + median.toFixed(2) + " ms, most " + most.toFixed(2) + " ms";
        }
    }
}
