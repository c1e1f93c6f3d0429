package starlogo.intersection
{
    import flash.errors.IllegalOperationError;
    import starlogo.bounding.BoundingStructure;
    import starlogo.convex.CoreGap;
    import starlogo.convex.RelativeMotion;

    /**
     * Finds the gap between the cores of two structures, one of which moves, and tests whether two touch where they stand. RoundKernel answers
     * all other questions by the gap. Abstract: there is a class for each pair of kinds. It has axes of its own, in which the gap is easy to find.
     * <code>begin()</code> sets them for two structures; the gap is in them until <code>placeGap()</code>.
     *
     * @private
     */
    public class GapFinder
    {
        /** Whether two structures touch where they stand. See PairKernel. */
        public function areTouching(a:BoundingStructure, b:BoundingStructure):Boolean
        {
            throw new IllegalOperationError(this + " does not implement areTouching");
        }

        /** Whether b comes before a, so that the distance of (b, a) is found in place of that of (a, b). Then rounding is the same for both. */
        public function areSwapped(a:BoundingStructure, b:BoundingStructure):Boolean
        {
            return false;
        }

        /**
         * Begins with two structures.
         *
         * @param a of the pair's first kind
         * @param b of the pair's second kind, in the same space
         * @param motion the motion of a
         * @param coreMotion receives the place and the motion of a's core, but not the time
         * @param out receives the extent and the radii
         */
        public function begin(a:BoundingStructure, b:BoundingStructure, motion:RelativeMotion, coreMotion:CoreMotion, out:CoreGap):void
        {
            throw new IllegalOperationError(this + " does not implement begin");
        }

        /** Finds the gap at the core's time, in the finder's axes. @param b of <code>begin()</code> */
        public function findGap(b:BoundingStructure, coreMotion:CoreMotion, out:CoreGap):void
        {
            throw new IllegalOperationError(this + " does not implement findGap");
        }

        /**
         * Turns the gap that was found last into the structures' space, and writes the closest point of a, where a is stored. The structures are those
         * of <code>begin()</code>.
         */
        public function placeGap(a:BoundingStructure, b:BoundingStructure, out:CoreGap):void
        {
            throw new IllegalOperationError(this + " does not implement placeGap");
        }
    }
}
