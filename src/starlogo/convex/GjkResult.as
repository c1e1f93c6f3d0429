package starlogo.convex
{
    /**
     * What GjkDistance finds about two cores, as a record: how far apart they are, where, and an axis that proves it. The search may end early, because
     * the cores are farther apart than CorePair.searchLimit, or do not touch in the time that is left. Then only the axis means something. The shapes'
     * radii do not count.
     */
    internal final class GjkResult
    {
        /** The distance: 0 if the cores overlap, Infinity if the search ended early. */
        public var distance:Number = 0;

        /**
         * The gap between the closest points. Its a is the pair's first core, and its b the second one. The closest point is where the first core is
         * stored, without its motion. If the cores overlap, the vector is 0.
         */
        public var gap:CoreGap = new CoreGap();

        /** The axis along which the cores are farthest apart, of all that the search has tried. Except for rounding it is the gap's direction. */
        public var axis:SeparatingAxis = new SeparatingAxis();

        /**
         * Whether the cores are no farther apart than they may be. A search may end at the first separation that is greater. The distance may be less
         * than that by rounding, so both count.
         *
         * @param cores the pair that this is about
         */
        public function isWithinLimit(cores:CorePair):Boolean
        {
            return distance <= cores.searchLimit && !(axis.separation > cores.searchLimit);
        }
    }
}
