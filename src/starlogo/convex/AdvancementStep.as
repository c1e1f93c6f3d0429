package starlogo.convex
{
    /**
     * A step on the way to the time of impact, as a record: what a sweep has found at the motion's time, and what advance() has to know of the steps
     * before.
     *
     * @private
     */
    public final class AdvancementStep
    {
        /** How many steps a sweep makes at most: see advance(). */
        public static const MAX_STEPS:int = 80;

        /** The gap between the two shapes along a direction that keeps them apart. No gap is left if it is not above 0. */
        public var gap:Number = 0;

        /** How fast the motion closes the gap along that direction. */
        public var speed:Number = 0;

        /** Whether the shapes touch, with all margins: see Touching. */
        public var isTouching:Boolean = false;

        /** The number of steps before this one. */
        public var count:int = 0;

        /** The time of an earlier step at which the shapes touched, but only across the margins; RelativeMotion.NEVER if there was none. */
        public var marginTouchTime:Number = RelativeMotion.NEVER;

        /** Begins with the first step. */
        public function reset():void
        {
            count = 0;
            marginTouchTime = RelativeMotion.NEVER;
        }
    }
}
