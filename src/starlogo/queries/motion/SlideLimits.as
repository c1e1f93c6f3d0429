package starlogo.queries.motion
{
    /**
     * How a slide may go, as a record. There are four ways: without limits (NONE), at one height (LEVEL), along the ground and walls (setWalls), and down
     * what is steep (setFall).
     *
     * @private
     */
    public final class SlideLimits
    {
        /** The least z of the normal of a level floor. */
        public static const LEVEL_Z:Number = 1 - 1e-12;

        // A value of walkableZ: no contact is a wall.
        private static const NO_WALLS:Number = -2;

        /** No limits. It must not be changed. */
        public static const NONE:SlideLimits = new SlideLimits();

        /** For a level motion that stays level: all contacts but level ones are upright walls. It must not be changed. */
        public static const LEVEL:SlideLimits = newLevel();

        /** A contact counts as an upright wall if the z of its normal is less than this. */
        public var walkableZ:Number = NO_WALLS;

        /** Whether the end is as high as the beginning, also if the body overlaps something deeply there: its contacts are upright walls too. */
        public var staysLevel:Boolean = false;

        /** The greatest length of its way on the ground plane. The planes of contacts can turn a motion up or down more level. */
        public var maxHorizontal:Number = Infinity;

        /** Whether it is a fall. In each corner a fall begins straight down again. So it has no momentum, and never goes up. */
        public var isFall:Boolean = false;

        /** For a fall: the least slope on which it goes on, as a tangent. */
        public var fallSlope:Number = 0;

        /** Whether a contact can be a wall. */
        public function get hasWalls():Boolean
        {
            return walkableZ != NO_WALLS;
        }

        /** Sets the limits of a way along the ground and walls. */
        public function setWalls(walkableZ:Number, maxHorizontal:Number):void
        {
            this.walkableZ = walkableZ;
            this.maxHorizontal = maxHorizontal;
            staysLevel = isFall = false;
        }

        /** Sets the limits of a fall. */
        public function setFall(fallSlope:Number, maxHorizontal:Number):void
        {
            this.fallSlope = fallSlope;
            this.maxHorizontal = maxHorizontal;
            walkableZ = NO_WALLS;
            staysLevel = false;
            isFall = true;
        }

        private static function newLevel():SlideLimits
        {
            var level:SlideLimits = new SlideLimits();
            level.setWalls(LEVEL_Z, Infinity);
            level.staysLevel = true;
            return level;
        }
    }
}
