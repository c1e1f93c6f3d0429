package starlogo.convex
{
    /** The gap between two cores, and a direction that keeps the cores apart, as a record. The shapes' radii do not count. */
    internal final class CoreWitness
    {
        /**
         * The gap. Its a is the pair's first core, and its b the second one. The closest point is where the first core is stored, without its motion.
         * If the cores overlap, the vector means nothing. If the search ended early, nothing of it means anything.
         */
        public var gap:CoreGap = new CoreGap();

        /**
         * The length of the gap: 0 if the cores overlap. Infinity if the search ended early, because the cores are farther apart than
         * CorePair.searchLimit, or do not touch in the time that is left.
         */
        public var distance:Number = 0;

        /**
         * A unit vector from the second core to the first, and how far the cores are apart along it, which is at most the distance. It is less than 0
         * if they overlap along the vector: CoreOverlap finds the greatest such number.
         */
        public var normalX:Number = 0;
        public var normalY:Number = 0;
        public var normalZ:Number = 1;
        public var separation:Number = 0;

        /**
         * Whether the cores are no farther apart than they may be. A search may end at the first separation that is greater. The distance may be less
         * than that by rounding, so both count.
         *
         * @param cores the pair that this is about
         */
        public function isWithinLimit(cores:CorePair):Boolean
        {
            return distance <= cores.searchLimit && !(separation > cores.searchLimit);
        }

        /** Sets the unit vector, and how far the cores are apart along it. */
        public function setAxis(x:Number, y:Number, z:Number, separation:Number):void
        {
            normalX = x;
            normalY = y;
            normalZ = z;
            this.separation = separation;
        }
    }
}
