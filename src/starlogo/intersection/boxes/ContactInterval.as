package starlogo.intersection.boxes
{
    import starlogo.geometry.Tolerances;

    /**
     * The interval of time in which no axis tried so far separates two moving shapes. The margin is included in the decision whether they
     * touch at all. The time of impact does not include it.
     *
     * @private
     */
    public final class ContactInterval
    {
        /** The end of the interval, with the margin included. Read only. */
        public var latest:Number = 1;

        /**
         * The time from which the last axis no longer separates the shapes, without the margin. If it is not after the end of the interval,
         * the shapes touch then. Read only.
         */
        public var timeOfImpact:Number = 0;

        // The beginning of the interval, with the margin included.
        private var _earliest:Number = 0;

        /** Begins with no axis tried. */
        public function reset(latest:Number):void
        {
            _earliest = timeOfImpact = 0;
            this.latest = latest;
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
            var speed:Number = axis.speed;
            var halfExtents:Number = axis.halfExtents;
            // mirrored, so that the motion is upwards
            if (speed < 0)
            {
                speed = -speed;
                from = -from;
            }
            var touchingDistance:Number = halfExtents * Tolerances.TOUCHING + axis.margin;
            var time:Number;
            if (from < -touchingDistance)
            {
                if (!(speed > 0))
                {
                    return false;
                }
                time = (-touchingDistance - from) / speed;
                if (time > latest)
                {
                    return false;
                }
                _earliest = time > _earliest ? time : _earliest;
                time = (-halfExtents - from) / speed;
                timeOfImpact = time > timeOfImpact ? time : timeOfImpact;
            }
            else if (from > touchingDistance)
            {
                return false;
            }
            if (from + latest * speed > touchingDistance)
            {
                time = (touchingDistance - from) / speed;
                if (time < _earliest)
                {
                    return false;
                }
                latest = time < latest ? time : latest;
            }
            return true;
        }
    }
}
