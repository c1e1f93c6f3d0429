package starlogo.intersection
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.engine;

    use namespace engine;

    /**
     * Finds the kernel of two structures by their kinds. The package intersection says how two structures meet: whether they touch
     * (<code>intersects()</code>, a function for each pair), when they first do (<code>sweep</code>), how they overlap (<code>contact</code>), how far apart
     * they are (<code>distance</code>), and where a ray meets one (<code>ray</code>); TriangleKernel tests a shape against triangles. Read
     * PairKernel next, which has the questions, then RoundKernel and SphereCapsuleGap.
     *
     * <p>Spheres, capsules and boxes have kernels of their own, because the convex core takes two to eleven times as long. It decides about hulls,
     * and in all other pairs where two cores overlap.</p>
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
            var convex:ConvexKernel = new ConvexKernel();
            for (var kind:int = 0; kind < KINDS; kind++)
            {
                kernels[KINDS * kind + BoundingStructure.HULL] = kernels[KINDS * BoundingStructure.HULL + kind] = convex;
            }
            var missing:PairKernel = new PairKernel();
            for (kind = 0; kind < KINDS; kind++)
            {
                kernels[KINDS * kind + BoundingStructure.OTHER] = kernels[KINDS * BoundingStructure.OTHER + kind] = missing;
            }
            addPair(kernels, BoundingStructure.SPHERE, BoundingStructure.SPHERE, new SphereSphereKernel());
            addPair(kernels, BoundingStructure.SPHERE, BoundingStructure.CAPSULE, new RoundKernel(new SphereCapsuleGap(), convex));
            addPair(kernels, BoundingStructure.SPHERE, BoundingStructure.BOX, new RoundKernel(new SphereBoxGap(), convex));
            addPair(kernels, BoundingStructure.CAPSULE, BoundingStructure.CAPSULE, new RoundKernel(new CapsuleCapsuleGap(), convex));
            addPair(kernels, BoundingStructure.CAPSULE, BoundingStructure.BOX, new RoundKernel(new CapsuleBoxGap(), convex));
            addPair(kernels, BoundingStructure.BOX, BoundingStructure.BOX, new BoxBoxKernel(convex));
            return kernels;
        }

        private static function addPair(kernels:Vector.<PairKernel>, a:int, b:int, kernel:PairKernel):void
        {
            kernels[KINDS * b + a] = new SwappedKernel(kernel);
            kernels[KINDS * a + b] = kernel;
        }
    }
}
