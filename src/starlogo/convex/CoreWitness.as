package starlogo.convex
{
    /** The closest points of two cores, and a direction that keeps the cores apart, as a record. The shapes' radii do not count. */
    internal final class CoreWitness
    {
        /**
         * The vector from b's closest point to a's, and its length. If the cores overlap, the length is 0, and the vector means nothing. If the
         * search ended early, the length is only more than CorePair.maxDistance, or too much for the time that is left.
         */
        public var x:Number = 0;
        public var y:Number = 0;
        public var z:Number = 0;
        public var distance:Number = 0;

        /** The closest point of a, relative to its origin. */
        public var pointX:Number = 0;
        public var pointY:Number = 0;
        public var pointZ:Number = 0;

        /** A unit vector from b to a along which the cores are apart, and how far they are apart along it: at most the distance. */
        public var normalX:Number = 0;
        public var normalY:Number = 0;
        public var normalZ:Number = 1;
        public var separation:Number = 0;
    }
}
