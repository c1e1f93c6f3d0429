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
        // With the gap.
        private var _first:Number;
        private var _last:Number;

        // When the last axis ceases to separate them, without the gap.
        private var _touch:Number;

        /** No time yet. */
        public function TouchingTimes()
        {
        }

        /** When they touch for the first time, unless an axis separates them. */
        public function get first():Number
        {
            return _touch < _last ? _touch : _last;
        }

        /**
         * Begins with no axis tried.
         *
         * @param latest the latest time that is of interest
         */
        public function reset(latest:Number):void
        {
            _first = _touch = 0;
            _last = latest;
        }

        /** Sets a time before which they do not touch; returns whether they may touch after it. */
        public function limitTo(time:Number):Boolean
        {
            _touch = time;
            return time <= _last;
        }

        /**
         * Tries an axis.
         *
         * @param at where on it the one's middle is, from the other's, at time 0
         * @param speed how far it moves along it till time 1
         * @param reach how far the two reach along it together
         * @param gap across which they still touch
         * @return whether it separates them all the time
         */
        public function areSeparated(at:Number, speed:Number, reach:Number, gap:Number):Boolean
        {
            // mirrored, so that it moves up
            if (speed < 0)
            {
                speed = -speed;
                at = -at;
            }
            var wide:Number = reach * Tolerances.TOUCHING + gap;
            var time:Number;
            if (at < -wide)
            {
                if (!(speed > 0))
                {
                    return true;
                }
                time = (-wide - at) / speed;
                if (time > _last)
                {
                    return true;
                }
                if (time > _first)
                {
                    _first = time;
                }
                time = (-reach - at) / speed;
                if (time > _touch)
                {
                    _touch = time;
                }
            }
            else if (at > wide)
            {
                return true;
            }
            if (at + _last * speed > wide)
            {
                time = (wide - at) / speed;
                if (time < _first)
                {
                    return true;
                }
                if (time < _last)
                {
                    _last = time;
                }
            }
            return false;
        }
    }
}
