package starlogo.queries.motion
{
    /**
     * How a slide may go.
     *
     * @private
     */
    public final class SlideLimits
    {
        /** A value of <code>walkableZ</code>: no contact is a wall. */
        public static const NO_WALLS:Number = -2;

        /** A value of <code>fallSlope</code>: the motion is no fall. */
        public static const NO_FALL:Number = -1;

        /** A value of <code>walkableZ</code>: the least z of the normal of a level floor. Contacts with all else are walls. */
        public static const LEVEL_Z:Number = 1 - 1e-12;

        /** No limits. Nothing writes to it. */
        public static const NONE:SlideLimits = new SlideLimits();

        /** For a level motion that stays level: all contacts but level ones are upright walls. Nothing writes to it. */
        public static const LEVEL:SlideLimits = newLevel();

        /** Whether the end is as high as the beginning, also if the body overlaps something deeply there: its contacts are upright walls too. */
        public var staysLevel:Boolean = false;

        /** A contact counts as an upright wall if the z of its normal is less than this. */
        public var walkableZ:Number = NO_WALLS;

        /** The greatest length of its way on the ground plane. The planes of contacts can turn a motion up or down more level. */
        public var maxHorizontal:Number = Infinity;

        /**
         * For a fall: the least slope on which it goes on, as a tangent, which is not negative. In each corner a fall begins
         * straight down again. So it has no momentum, and never goes up.
         */
        public var fallSlope:Number = NO_FALL;

        /** Sets all limits. */
        public function setTo(walkableZ:Number, maxHorizontal:Number, fallSlope:Number):void
        {
            this.walkableZ = walkableZ;
            this.maxHorizontal = maxHorizontal;
            this.fallSlope = fallSlope;
        }

        private static function newLevel():SlideLimits
        {
            var level:SlideLimits = new SlideLimits();
            level.walkableZ = LEVEL_Z;
            level.staysLevel = true;
            return level;
        }
    }
}
