package starlogo.intersection
{
    import starlogo.bounding.BoundingStructure;

    /** The table of pairs: which kernel belongs to two kinds. */
    public final class PairTable
    {
        // By the kind of the first times four and that of the second; the first has the lower kind.
        private static const KERNELS:Vector.<PairKernel> = new <PairKernel>[
                new PointPoint(), new PointSegment(), new PointBox(), null,
                null, new SegmentSegment(), new SegmentBox(), null,
                null, null, new BoxPair()];

        /** The table is a constant; there are no instances. */
        public function PairTable()
        {
        }

        /**
         * The kernel of two structures.
         *
         * @param a its kind is not above b's
         * @param b a Sphere, Capsule or Box
         * @throws ArgumentError when there is no test for the pair
         *
         * @private
         */
        public static function kernelOf(a:BoundingStructure, b:BoundingStructure):PairKernel
        {
            if (b.kind > BoundingStructure.BOX)
            {
                throw new ArgumentError("there is no intersection test for " + a + " and " + b);
            }
            return KERNELS[a.kind << 2 | b.kind];
        }
    }
}
