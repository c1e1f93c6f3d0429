package starlogo.convex
{
    /**
     * The gap between two balls, as a record: they touch if it is at most as long as the touch distance.
     *
     * @private
     */
    public final class BallGap
    {
        /** The vector from the centre of the second ball to that of the first one. */
        public var x:Number = 0;
        public var y:Number = 0;
        public var z:Number = 0;

        /** The largest distance of the centres at which the two touch. */
        public var touchDistance:Number = 0;
    }
}
