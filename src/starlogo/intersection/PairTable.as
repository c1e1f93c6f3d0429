package starlogo.intersection
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.engine;

    use namespace engine;

    /**
     * Finds the kernel of a pair of structures by their two kinds: <code>OF[a.kind].against[b.kind]</code>. The convex core tests every pair
     * with a kind from HULL on.
     *
     * <p>The package intersection says how two structures meet: whether they touch (<code>intersects()</code>), when they first do
     * (<code>sweep</code>), how they overlap (<code>contact</code>), how far apart they are (<code>distance</code>), and where a ray meets one
     * (<code>ray</code>). Whether they touch is a function for each pair; the rest is a kernel for each pair, and ConvexTriangle tests a
     * shape against triangles. Read PairKernel first, then SphereCapsuleKernel and NewtonSteps.</p>
     *
     * @private
     */
    public final class PairTable
    {
        /** The kernels, by the first structure's kind. */
        public static const OF:Vector.<KindKernels> = makeKernels();

        private static function makeKernels():Vector.<KindKernels>
        {
            var kernels:Vector.<KindKernels> = new Vector.<KindKernels>();
            var missing:PairKernel = new PairKernel();
            for (var a:int = 0; a <= BoundingStructure.OTHER; a++)
            {
                kernels[a] = new KindKernels();
                for (var b:int = 0; b <= BoundingStructure.OTHER; b++)
                {
                    kernels[a].against[b] = missing;
                }
            }
            addPair(kernels, BoundingStructure.SPHERE, BoundingStructure.SPHERE, new SphereSphereKernel());
            addPair(kernels, BoundingStructure.SPHERE, BoundingStructure.CAPSULE, new SphereCapsuleKernel());
            addPair(kernels, BoundingStructure.SPHERE, BoundingStructure.BOX, new SphereBoxKernel());
            addPair(kernels, BoundingStructure.CAPSULE, BoundingStructure.CAPSULE, new CapsuleCapsuleKernel());
            addPair(kernels, BoundingStructure.CAPSULE, BoundingStructure.BOX, new CapsuleBoxKernel());
            addPair(kernels, BoundingStructure.BOX, BoundingStructure.BOX, new BoxBoxKernel());
            for (b = BoundingStructure.HULL; b < BoundingStructure.KIND_COUNT; b++)
            {
                for (a = 0; a <= b; a++)
                {
                    addPair(kernels, a, b, new ConvexKernel());
                }
            }
            return kernels;
        }

        private static function addPair(kernels:Vector.<KindKernels>, a:int, b:int, kernel:PairKernel):void
        {
            kernels[b].against[a] = new SwappedKernel(kernel);
            kernels[a].against[b] = kernel;
        }
    }
}
