package starlogo.intersection
{
    /**
     * The kernels of the pairs whose first structure is of one kind.
     *
     * @private
     */
    public final class KindKernels
    {
        /** The kernels, by the second structure's kind. */
        public var against:Vector.<PairKernel> = new Vector.<PairKernel>();
    }
}
