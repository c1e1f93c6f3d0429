package starlogo.intersection
{
    import flash.errors.IllegalOperationError;
    import starlogo.bounding.BoundingStructure;
    import starlogo.convex.RelativeMotion;

    /**
     * Finds the gap between the cores of two structures, by which RoundKernel answers its questions. Abstract: each class has a
     * formula. If these were classes of kernels, PairTable would have kernels of six classes, and V8 calls a method of more than four classes slowly.
     *
     * @private
     */
    public class GapFinder
    {
        /**
         * Finds the gap.
         *
         * @param a of the pair's first kind
         * @param b of the pair's second kind, in the same space
         * @param motion the motion of a; a is where it is at the motion's time
         * @param out receives all of the gap
         */
        public function find(a:BoundingStructure, b:BoundingStructure, motion:RelativeMotion, out:RoundGap):void
        {
            throw new IllegalOperationError(this + " does not implement find");
        }
    }
}
