package starlogo.intersection
{
    /**
     * The table of pairs: which kernel belongs to two kinds.
     *
     * @private
     */
    public final class PairTable
    {
        // Of cylinders.
        private static const NONE:PairKernel = new PairKernel();

        /** By the kind of the first times four and that of the second. The first has the lower kind; where it has not, there is no kernel. */
        public static const KERNELS:Vector.<PairKernel> = new <PairKernel>[
                new PointPoint(), new PointSegment(), new PointBox(), NONE,
                NONE, new SegmentSegment(), new SegmentBox(), NONE,
                NONE, NONE, new BoxPair(), NONE,
                NONE, NONE, NONE, NONE];

        /** The table is a constant; there are no instances. */
        public function PairTable()
        {
        }
    }
}
