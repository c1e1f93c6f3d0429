package starlogo.intersection.boxes
{
    import starlogo.geometry.Tolerances;

    /**
     * The interval of time in which no axis tried so far separates two moving shapes. Callers write how the shapes move along an axis of any length, and
     * then clip the interval by it. The margin is included in the decision whether they touch at all. The time of impact does not include it.
     *
     * @private
     */
    public final class ContactInterval
    {
        /** Of the axis: the place of the second shape's middle at time 0, seen from the first one's. */
        public var offset:Number = 0;

        /** How far the second shape moves along the axis until time 1. */
        public var speed:Number = 0;

        /** The half-extents of both shapes along the axis, added. */
        public var halfExtents:Number = 0;

        /** The gap along the axis across which the shapes still touch. */
        public var margin:Number = 0;

        /** The end of the interval, with the margin included. Read only. */
        public var latestTime:Number = 1;

        /**
         * The time from which the last axis no longer separates the shapes, without the margin. If it is not after the end of the interval,
         * the shapes touch then. Read only.
         */
        public var timeOfImpact:Number = 0;

        // The beginning of the interval, with the margin included.
        private var _earliestTime:Number = 0;

        /** Begins with no axis tried. */
        public function reset(latestTime:Number):void
        {
            _earliestTime = timeOfImpact = 0;
            this.latestTime = latestTime;
        }

        /** Clips the interval to the time in which the axis does not separate the shapes. Returns whether anything is left. If not, they do not touch. */
        public function clip():Boolean
        {
            var from:Number = offset;
            var rise:Number = speed;
            // mirrored, so that the motion is upwards
            if (rise < 0)
            {
                rise = -rise;
                from = -from;
            }
            var touchingDistance:Number = halfExtents * Tolerances.TOUCHING + margin;
            var time:Number;
            if (from < -touchingDistance)
            {
                if (!(rise > 0))
                {
                    return false;
                }
                time = (-touchingDistance - from) / rise;
                if (time > latestTime)
                {
                    return false;
                }
                _earliestTime = time > _earliestTime ? time : _earliestTime;
                time = (-halfExtents - from) / rise;
                timeOfImpact = time > timeOfImpact ? time : timeOfImpact;
            }
            else if (from > touchingDistance)
            {
                return false;
            }
            if (from + latestTime * rise > touchingDistance)
            {
                time = (touchingDistance - from) / rise;
                if (time < _earliestTime)
                {
                    return false;
                }
                latestTime = time < latestTime ? time : latestTime;
            }
            return true;
        }
    }
}
