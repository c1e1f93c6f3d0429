package starlogo.intersection
{
    import starlogo.convex.CoreGap;

    /**
     * The gap between the cores of two structures of which the first moves, with what RoundKernel has to know about it, as a record. GapFinder
     * writes it.
     */
    internal final class RoundGap
    {
        /** The gap and the radii. The closest point is where the first structure is stored, without its motion. */
        public var gap:CoreGap = new CoreGap();

        /** The squared length of the gap. At a box it is more precise than its vector. */
        public var squaredLength:Number = 0;

        /** How fast the motion closes the gap, times the length of the gap. */
        public var closing:Number = 0;

        /** The extent of both structures together, which the rounding error of the gap is relative to. */
        public var extent:Number = 0;
    }
}
