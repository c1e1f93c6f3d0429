package starlogo.intersection.boxes
{
    import starlogo.geometry.Tolerances;

    /**
     * The interval of time in which no axis tried so far separates two moving shapes. Axes may have any length. The margin is included in the decision
     * whether the shapes touch at all. The time of impact does not include it.
     *
     * @private
     */
    public final class ContactInterval
    {
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

        /**
         * Clips the interval to the time in which an axis does not separate the shapes.
         *
         * @param from the place of the second shape's middle along the axis at time 0, seen from the first one's
         * @param speed how far the second shape moves along the axis until time 1
         * @param halfExtents of both shapes along the axis, added
         * @param margin the gap along the axis across which the shapes still touch
         * @return whether anything is left. If not, they do not touch
         */
        public function clip(from:Number, speed:Number, halfExtents:Number, margin:Number):Boolean
        {
            // mirrored, so that the motion is upwards
            if (speed < 0)
            {
                speed = -speed;
                from = -from;
            }
            var touchingDistance:Number = halfExtents * Tolerances.TOUCHING + margin;
            var time:Number;
            if (from < -touchingDistance)
            {
                if (!(speed > 0))
                {
                    return false;
                }
                time = (-touchingDistance - from) / speed;
                if (time > latestTime)
                {
                    return false;
                }
                _earliestTime = time > _earliestTime ? time : _earliestTime;
                time = (-halfExtents - from) / speed;
                timeOfImpact = time > timeOfImpact ? time : timeOfImpact;
            }
            else if (from > touchingDistance)
            {
                return false;
            }
            if (from + latestTime * speed > touchingDistance)
            {
                time = (touchingDistance - from) / speed;
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
