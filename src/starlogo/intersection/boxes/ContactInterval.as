package starlogo.intersection.boxes
{
    import starlogo.geometry.Tolerances;

    /**
     * The interval of time in which no axis tried so far separates two moving shapes, and the projections of the shapes on the next axis. The axis may
     * have any length. The margins are included in the decision whether they touch at all. The time of impact does not include them.
     *
     * @private
     */
    public final class ContactInterval
    {
        /** On the axis, the place of the second shape's middle at time 0, seen from the first one's. */
        public var offset:Number = 0;

        /** How far the second shape moves along the axis until time 1. */
        public var travel:Number = 0;

        /** The half-extents of both shapes along the axis, added. */
        public var halfExtents:Number = 0;

        /** The gap on the axis across which the shapes still touch. */
        public var margin:Number = 0;

        /** The end of the interval, with the margins included. Read only. */
        public var last:Number = 1;

        /**
         * The time from which the last axis no longer separates the shapes, without the margins. If it is not after the end of the interval,
         * the shapes touch then. Read only.
         */
        public var touch:Number = 0;

        // The beginning of the interval, with the margins included.
        private var _first:Number = 0;

        /** Begins with no axis tried. */
        public function begin(latest:Number):void
        {
            _first = touch = 0;
            last = latest;
        }

        /**
         * Narrows the interval to the time in which the axis does not separate the shapes.
         *
         * @return whether anything is left. If not, the shapes do not touch
         */
        public function narrow():Boolean
        {
            // mirrored, so that the motion is upwards
            var side:int = travel < 0 ? -1 : 1;
            var from:Number = side * offset;
            var speed:Number = side * travel;
            var near:Number = halfExtents;
            var wide:Number = near * Tolerances.TOUCHING + margin;
            var time:Number;
            if (from < -wide)
            {
                if (!(speed > 0))
                {
                    return false;
                }
                time = (-wide - from) / speed;
                if (time > last)
                {
                    return false;
                }
                if (time > _first)
                {
                    _first = time;
                }
                time = (-near - from) / speed;
                if (time > touch)
                {
                    touch = time;
                }
            }
            else if (from > wide)
            {
                return false;
            }
            if (from + last * speed > wide)
            {
                time = (wide - from) / speed;
                if (time < _first)
                {
                    return false;
                }
                if (time < last)
                {
                    last = time;
                }
            }
            return true;
        }
    }
}
