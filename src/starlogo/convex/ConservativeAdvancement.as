package starlogo.convex
{
    import starlogo.geometry.Tolerances;

    /**
     * Moves the time of a motion towards the time of impact, by conservative advancement (van den Bergen, "Ray casting against general convex objects with
     * application to continuous collision detection", 2004). The distance of two convex shapes is a convex function of the time. So Newton's method
     * from the left never steps over its first zero. A sweep measures the shapes at the motion's time, writes what it finds here, and asks for the
     * next time, as long as there is one.
     *
     * <p>If the shapes touch across the margins only, one more step leads to where they touch without them. It counts if they still touch there. The gap
     * leaves the margins out. So the steps may pass two shapes that touch across the margins alone, if they part again before the motion ends.</p>
     *
     * <p>Each step shrinks the product of the separation and its slope to at most a quarter, and both are numbers of 53 bits. So MAX_STEPS steps are
     * enough. Should rounding need more, the time is that of the last step: the shapes do not touch before, and their gap is at most rounding.</p>
     *
     * @private
     */
    public final class ConservativeAdvancement
    {
        private static const MAX_STEPS:int = 80;

        /**
         * How far the two shapes are apart along a direction that keeps them apart, or in all directions. It is above 0 unless they touch. So shapes that do
         * not close it in time never touch.
         */
        public var separation:Number = 0;

        /** How fast the motion closes the separation, or faster. */
        public var speed:Number = 0;

        /** Whether the shapes touch, with all margins: see Touching. */
        public var isTouching:Boolean = false;

        // The number of steps before this one.
        private var _count:int = 0;

        // The time of an earlier step at which the shapes touched, but only across the margins; RelativeMotion.NEVER if there was none.
        private var _marginTouchTime:Number = RelativeMotion.NEVER;

        /** Begins with the first step. */
        public function reset():void
        {
            _count = 0;
            _marginTouchTime = RelativeMotion.NEVER;
        }

        /**
         * Moves to the next step.
         *
         * @param motion receives the time of the next step. If there is none, receives the answer: when the shapes touch, or RelativeMotion.NEVER
         * @return whether there is another step
         */
        public function advance(motion:RelativeMotion):Boolean
        {
            if (_marginTouchTime != RelativeMotion.NEVER)
            {
                if (!isTouching)
                {
                    // the step after the touch has led out of it
                    motion.time = _marginTouchTime;
                }
                return false;
            }
            if (isTouching)
            {
                if (motion.time == 0)
                {
                    return false;
                }
                _marginTouchTime = motion.time;
            }
            var next:Number = motion.time + separation / speed;
            // rounding must not hide a touch at the end
            next = next > motion.latestTime && next <= motion.latestTime + Tolerances.SAME_TIME ? motion.latestTime : next;
            if (!(speed > 0 && next > motion.time && next <= motion.latestTime))
            {
                // there is no step in time
                motion.time = _marginTouchTime;
                return false;
            }
            motion.time = next;
            _count++;
            return _count < MAX_STEPS;
        }
    }
}
