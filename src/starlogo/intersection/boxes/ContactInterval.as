package starlogo.intersection.boxes
{
    import starlogo.geometry.Tolerances;

    /**
     * The interval of time in which no axis tried so far separates two moving shapes. The tolerance is included in the decision whether they
     * touch at all. The time of impact does not include it.
     *
     * @private
     */
    public final class ContactInterval
    {
        /** The end of the interval, with the tolerance included. Read only. */
        public var last:Number = 1;

        /**
         * The time from which the last axis no longer separates the shapes, without the tolerance. If it is not after the end of the interval,
         * the shapes touch then. Read only.
         */
        public var touch:Number = 0;

        // The beginning of the interval, with the tolerance included.
        private var _first:Number = 0;

        /** Begins with no axis tried. */
        public function begin(latest:Number):void
        {
            _first = touch = 0;
            last = latest;
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
            var halfExtents:Number = axis.halfExtents;
            // mirrored, so that the motion is upwards
            if (travel < 0)
            {
                travel = -travel;
                from = -from;
            }
            var touchingDistance:Number = halfExtents * Tolerances.TOUCHING + axis.tolerance;
            var time:Number;
            if (from < -touchingDistance)
            {
                if (!(travel > 0))
                {
                    return false;
                }
                time = (-touchingDistance - from) / travel;
                if (time > last)
                {
                    return false;
                }
                _first = time > _first ? time : _first;
                time = (-halfExtents - from) / travel;
                touch = time > touch ? time : touch;
            }
            else if (from > touchingDistance)
            {
                return false;
            }
            if (from + last * travel > touchingDistance)
            {
                time = (touchingDistance - from) / travel;
                if (time < _first)
                {
                    return false;
                }
                last = time < last ? time : last;
            }
            return true;
        }
    }
}
