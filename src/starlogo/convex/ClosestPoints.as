package starlogo.convex
{
    /**
     * The distance of two shapes and their closest points, as a record. If the shapes overlap, the distance is 0, and both points are one point of
     * both.
     *
     * @private
     */
    public final class ClosestPoints
    {
        /** The distance. ConvexPair.findCloser() looks only for a distance below it. */
        public var distance:Number = Infinity;

        /** The point of the first shape. */
        public var aX:Number = 0;
        public var aY:Number = 0;
        public var aZ:Number = 0;

        /** The point of the second shape. */
        public var bX:Number = 0;
        public var bY:Number = 0;
        public var bZ:Number = 0;
    }
}
