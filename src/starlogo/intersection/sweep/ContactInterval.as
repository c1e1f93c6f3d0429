package starlogo.intersection.sweep
{
    import starlogo.geometry.Tolerances;

    /**
     * The interval of time in which no axis tried so far separates two moving shapes. A gap for rounding is included in the decision
     * whether they touch at all. The time of impact does not include it.
     *
     * @private
     */
    public final class ContactInterval
    {
        /** The next axis to try: the place of one middle on it at time 0, as seen from the other middle. */
        public var at:Number = 0;

        /** How far that middle moves along the axis until time 1. */
        public var speed:Number = 0;

        /** The sum of how far both shapes extend along the axis. */
        public var reach:Number = 0;

        /** The gap across which the shapes still touch. */
        public var gap:Number = 0;

        /** The end of the interval, with the gap included. */
        public var last:Number = 1;

        /**
         * The time from which the last axis no longer separates the shapes, without the gap. If it is not after the end of the interval,
         * the shapes touch then.
         */
        public var touch:Number = 0;

        // The beginning of the interval, with the gap included.
        private var _first:Number = 0;

        /** Begins again with no axis tried. <code>last</code> must be the latest time to look at. */
        public function reset():void
        {
            _first = touch = 0;
        }

        /**
         * Tries the axis that the fields describe. They are fields, because V8 would allocate objects for arguments.
         *
         * @return whether the axis separates the shapes all the time
         */
        public function areSeparated():Boolean
        {
            var from:Number = at;
            var rate:Number = speed;
            var near:Number = reach;
            // mirrored, so that the motion is upwards
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
