package starlogo.intersection
{
    /**
     * Finds the kernel of a pair of structures by their two kinds.
     *
     * @private
     */
    public final class PairTable
    {
        // For pairs with a cylinder, and for pairs in the wrong order.
        private static const NONE:PairKernel = new PairKernel();

        /**
         * The kernels, by four times the first structure's kind plus the second's. The first kind must not be higher than the second: the
         * other entries have no test.
         */
        public static const KERNELS:Vector.<PairKernel> = new <PairKernel>[
                new PointPoint(), new PointSegment(), new PointBox(), NONE,
                NONE, new SegmentSegment(), new SegmentBox(), NONE,
                NONE, NONE, new BoxPair(), NONE,
                NONE, NONE, NONE, NONE];
    }
}
