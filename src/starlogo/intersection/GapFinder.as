package starlogo.intersection
{
    import flash.errors.IllegalOperationError;
    import starlogo.bounding.BoundingStructure;
    import starlogo.convex.CoreGap;
    import starlogo.convex.RelativeMotion;

    /**
     * Finds the gap between the cores of two structures, one of which moves, and tests whether two touch where they stand. RoundKernel answers
     * all other questions by the gap. Abstract: there is a class for each pair of kinds. Between the calls for two structures it keeps where they are
     * in axes of its own, in which the gap is easy to find.
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
         * @param localMotion receives the motion in the finder's axes: where a's core is at time 0 as seen from b's, and how it moves from there
         * @param out receives the extent and the radii
         */
        public function begin(a:BoundingStructure, b:BoundingStructure, motion:RelativeMotion, localMotion:RelativeMotion, out:CoreGap):void
        {
            throw new IllegalOperationError(this + " does not implement begin");
        }

        /** Finds the gap at the motion's time. It is a vector in the finder's axes. @param b of <code>begin()</code> */
        public function find(b:BoundingStructure, localMotion:RelativeMotion, out:CoreGap):void
        {
            throw new IllegalOperationError(this + " does not implement find");
        }

        /**
         * Turns the gap that was found last into the structures' space, and writes the closest point of a, where a is stored. The structures are those
         * of <code>begin()</code>.
         */
        public function finish(a:BoundingStructure, b:BoundingStructure, out:CoreGap):void
        {
            throw new IllegalOperationError(this + " does not implement finish");
        }
    }
}
