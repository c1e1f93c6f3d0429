package starlogo.intersection.sweep
{
    import starlogo.geometry.Tolerances;

    /**
     * The interval of time in which no axis tried so far separates two shapes that pass each other. Whether they touch at all is decided with a gap
     * for rounding, the time of impact without one.
     *
     * @private
     */
    public final class TouchingTimes
    {
        /** Where on the axis that is tried next the one's middle is, from the other's, at time 0. */
        public var at:Number = 0;

        /** How far it moves along it till time 1. */
        public var speed:Number = 0;

        /** How far the two reach along it together. */
        public var reach:Number = 0;

        /** The gap across which they still touch. */
        public var gap:Number = 0;

        /** The end of the interval, with the gap. */
        public var last:Number = 1;

        /** When the last axis ceases to separate them, without the gap. If that is not after the end, they touch then. */
        public var touch:Number = 0;

        // The beginning, with the gap.
        private var _first:Number = 0;

        /** No time yet. */
        public function TouchingTimes()
        {
        }

        /** Begins with no axis tried: <code>last</code> is the latest time that is of interest. */
        public function reset():void
        {
            _first = touch = 0;
        }

        /**
         * Tries the axis that the fields describe: of arguments V8 would make objects.
         *
         * @return whether it separates them all the time
         */
        public function areSeparated():Boolean
        {
            var from:Number = at;
            var rate:Number = speed;
            var near:Number = reach;
            // mirrored, so that it moves up
            if (rate < 0)
            {
                rate = -rate;
                from = -from;
            }
            var wide:Number = near * Tolerances.TOUCHING + gap;
            var time:Number;
            if (from < -wide)
            {
                if (!(rate > 0))
                {
                    return true;
                }
                time = (-wide - from) / rate;
                if (time > last)
                {
                    return true;
                }
                if (time > _first)
                {
                    _first = time;
                }
                time = (-near - from) / rate;
                if (time > touch)
                {
                    touch = time;
                }
            }
            else if (from > wide)
            {
                return true;
            }
            if (from + last * rate > wide)
            {
                time = (wide - from) / rate;
                if (time < _first)
                {
                    return true;
                }
                if (time < last)
                {
                    last = time;
                }
            }
            return false;
        }
    }
}
