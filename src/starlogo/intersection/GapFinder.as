package starlogo.intersection
{
    import flash.errors.IllegalOperationError;
    import starlogo.bounding.BoundingStructure;
    import starlogo.convex.CoreGap;
    import starlogo.convex.RelativeMotion;

    /**
     * Finds the gap between the cores of two structures, by which RoundKernel answers its questions. Abstract: there is a class for each pair of
     * kinds.
     *
     * @private
     */
    public class GapFinder
    {
        /** Whether b comes before a, so that the distance of (b, a) is found in place of that of (a, b). Then rounding is the same for both. */
        public function areSwapped(a:BoundingStructure, b:BoundingStructure):Boolean
        {
            return false;
        }

        /**
         * Finds the gap.
         *
         * @param a of the pair's first kind
         * @param b of the pair's second kind, in the same space
         * @param motion the motion of a; a is where it is at the motion's time
         * @param out receives all of the gap, the radii and the extent
         */
        public function find(a:BoundingStructure, b:BoundingStructure, motion:RelativeMotion, out:CoreGap):void
        {
            throw new IllegalOperationError(this + " does not implement find");
        }
    }
}
