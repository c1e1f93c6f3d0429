package starlogo.convex
{
    /** The gap between two cores, and a direction that keeps the cores apart, as a record. The shapes' radii do not count. */
    internal final class CoreWitness
    {
        /**
         * The gap. The closest point of the first core is relative to its origin. If the cores overlap, the vector means nothing. If the search ended
         * early, nothing of it means anything.
         */
        public var gap:CoreGap = new CoreGap();

        /**
         * The length of the gap: 0 if the cores overlap. Infinity if the search ended early, because the cores are farther apart than
         * CorePair.maxDistance, or do not touch in the time that is left.
         */
        public var distance:Number = 0;

        /**
         * A unit vector from the second core to the first along which the cores are apart, and how far they are apart along it, which is at most the
         * distance.
         */
        public var normalX:Number = 0;
        public var normalY:Number = 0;
        public var normalZ:Number = 1;
        public var separation:Number = 0;
    }
}
