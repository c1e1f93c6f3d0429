package starlogo.queries.motion
{
    /**
     * How a slide may go.
     *
     * @private
     */
    public final class SlideLimits
    {
        /** No limits. Nothing writes to it. */
        public static const NONE:SlideLimits = new SlideLimits();

        /** A contact counts as an upright wall if the z of its normal is less than this. With -2 none does so. */
        public var walkableZ:Number = -2;

        /** The greatest length of its way on the ground plane. The planes of contacts can turn a motion up or down more level. */
        public var maxHorizontal:Number = Infinity;

        /**
         * For a fall: the least slope on which it goes on, as a tangent; less than 0 if the motion is no fall. In each corner a fall begins
         * straight down again. So it has no momentum, and never goes up.
         */
        public var fallSlope:Number = -1;

        /** Sets all limits. */
        public function setTo(walkableZ:Number, maxHorizontal:Number, fallSlope:Number):void
        {
            this.walkableZ = walkableZ;
            this.maxHorizontal = maxHorizontal;
            this.fallSlope = fallSlope;
        }
    }
}
