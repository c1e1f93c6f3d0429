package starlogo.intersection
{
    import starlogo.intersection.sweep.RelativeMotion;

    /**
     * Finds the kernel of a pair of structures by their two kinds.
     *
     * @private
     */
    public final class PairTable
    {
        /** The motion of a pair in the other order. */
        public static const REVERSED:RelativeMotion = new RelativeMotion();

        /**
         * The kernels, by three times the first structure's kind plus the second's. The first kind must not be higher than the second.
         */
        public static const KERNELS:Vector.<PairKernel> = new <PairKernel>[
                new SphereSphereKernel(), new SphereCapsuleKernel(), new SphereBoxKernel(),
                null, new CapsuleCapsuleKernel(), new CapsuleBoxKernel(),
                null, null, new BoxBoxKernel()];

        /** The kernels that find distances. */
        public static const DISTANCES:Vector.<PairKernel> = KERNELS.slice(0, 8).concat(new <PairKernel>[new BoxDistanceKernel()]);
    }
}
