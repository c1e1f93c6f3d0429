package starlogo.intersection.sweep
{
    import starlogo.geometry.Tolerances;

    /**
     * The interval of time in which no axis tried so far separates two moving shapes. The margins are included in the decision whether they
     * touch at all. The time of impact does not include them.
     *
     * @private
     */
    public final class ContactInterval
    {
        // The interval, with the margins included.
        private var _first:Number = 0;
        private var _last:Number = 1;

        // The time from which no axis separates the shapes, without the margins.
        private var _touch:Number = 0;

        /** The time of impact if an interval is left. Shapes that touch only because of the margins may touch at its end. */
        public function get time():Number
        {
            return _touch < _last ? _touch : _last;
        }

        /** Begins with no axis tried. */
        public function begin(latest:Number):void
        {
            _first = _touch = 0;
            _last = latest;
        }

        /**
         * Narrows the interval to the time in which an axis does not separate the shapes.
         *
         * @param axis how the shapes move along it
         * @return whether anything is left. If not, the shapes do not touch
         */
        public function narrow(axis:AxisMotion):Boolean
        {
            var from:Number = axis.offset;
            var travel:Number = axis.travel;
            var near:Number = axis.halfExtents;
            // mirrored, so that the motion is upwards
            if (travel < 0)
            {
                travel = -travel;
                from = -from;
            }
            var wide:Number = near * Tolerances.TOUCHING + axis.margin;
            var time:Number;
            if (from < -wide)
            {
                if (!(travel > 0))
                {
                    return false;
                }
                time = (-wide - from) / travel;
                if (time > _last)
                {
                    return false;
                }
                if (time > _first)
                {
                    _first = time;
                }
                time = (-near - from) / travel;
                if (time > _touch)
                {
                    _touch = time;
                }
            }
            else if (from > wide)
            {
                return false;
            }
            if (from + _last * travel > wide)
            {
                time = (wide - from) / travel;
                if (time < _first)
                {
                    return false;
                }
                if (time < _last)
                {
                    _last = time;
                }
            }
            return true;
        }
    }
}
