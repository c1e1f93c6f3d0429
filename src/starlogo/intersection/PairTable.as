package starlogo.intersection
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.engine;

    use namespace engine;

    /**
     * Finds the kernel of a pair of structures by their two kinds. The convex core tests every pair
     * with a hull.
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
        private static const KINDS:int = BoundingStructure.OTHER + 1;

        // For each pair of kinds its kernel: one row after the other, a row for each kind of the first structure.
        private static const KERNELS:Vector.<PairKernel> = makeKernels();

        /** The kernel of two structures. */
        public static function kernelOf(a:BoundingStructure, b:BoundingStructure):PairKernel
        {
            return KERNELS[int(KINDS * a.kind + b.kind)];
        }

        private static function makeKernels():Vector.<PairKernel>
        {
            var kernels:Vector.<PairKernel> = new Vector.<PairKernel>(KINDS * KINDS, true);
            var missing:PairKernel = new PairKernel();
            for (var i:int = 0; i < kernels.length; i++)
            {
                kernels[i] = missing;
            }
            addPair(kernels, BoundingStructure.SPHERE, BoundingStructure.SPHERE, new SphereSphereKernel());
            addPair(kernels, BoundingStructure.SPHERE, BoundingStructure.CAPSULE, new SphereCapsuleKernel());
            addPair(kernels, BoundingStructure.SPHERE, BoundingStructure.BOX, new SphereBoxKernel());
            addPair(kernels, BoundingStructure.CAPSULE, BoundingStructure.CAPSULE, new CapsuleCapsuleKernel());
            addPair(kernels, BoundingStructure.CAPSULE, BoundingStructure.BOX, new CapsuleBoxKernel());
            addPair(kernels, BoundingStructure.BOX, BoundingStructure.BOX, new BoxBoxKernel());
            for (var b:int = BoundingStructure.HULL; b < BoundingStructure.KIND_COUNT; b++)
            {
                for (var a:int = 0; a <= b; a++)
                {
                    addPair(kernels, a, b, new ConvexKernel());
                }
            }
            return kernels;
        }

        private static function addPair(kernels:Vector.<PairKernel>, a:int, b:int, kernel:PairKernel):void
        {
            kernels[KINDS * b + a] = new SwappedKernel(kernel);
            kernels[KINDS * a + b] = kernel;
        }
    }
}
