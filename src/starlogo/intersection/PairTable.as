package starlogo.intersection
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.convex.ClosestPoints;
    import starlogo.convex.ContactPoint;
    import starlogo.convex.RelativeMotion;
    import starlogo.engine;

    use namespace engine;

    /**
     * Says how two structures meet: whether they touch, when a moving one first touches the other, how they overlap, and how far apart they are.
     * Here alone it is decided which kernel answers for two kinds. The package is made of a kernel for each pair of kinds, a ConvexTrianglePair for a
     * shape and triangles, and the tests of moving boxes (<code>sweep</code>) and of rays (<code>ray</code>). Read PairKernel next, which explains
     * the questions, then RoundKernel and SphereBoxGapFinder.
     *
     * <p>Spheres, capsules and boxes have kernels of their own, because the package convex takes two to eleven times as long. That package decides
     * about hulls. It also finds the distance of two boxes and their contact, and the contact of a sphere or capsule whose core overlaps the core of
     * a capsule or box.</p>
     *
     * @private
     */
    public final class PairTable
    {
        private static const KINDS:int = BoundingStructure.OTHER + 1;

        // For each pair of kinds its kernel: one row after the other, a row for each kind of the first structure. The methods read it themselves,
        // because these tests are short, and calls take long in Adobe's VM.
        private static const KERNELS:Vector.<PairKernel> = makeKernels();

        /** Whether two structures touch or overlap. See PairKernel. Games call it as <code>intersects()</code>. */
        public static function areTouching(a:BoundingStructure, b:BoundingStructure):Boolean
        {
            return KERNELS[int(KINDS * a.kind + b.kind)].areTouching(a, b);
        }

        /** Finds when a moving structure first touches another one. See PairKernel. */
        public static function findTime(a:BoundingStructure, b:BoundingStructure, motion:RelativeMotion):void
        {
            KERNELS[int(KINDS * a.kind + b.kind)].findTime(a, b, motion);
        }

        /** Finds where two structures touch, or how they overlap. See PairKernel. */
        public static function findContact(a:BoundingStructure, b:BoundingStructure, motion:RelativeMotion, out:ContactPoint):void
        {
            KERNELS[int(KINDS * a.kind + b.kind)].findContact(a, b, motion, out);
        }

        /** Finds the distance of two structures and their closest points. See PairKernel. */
        public static function findClosest(a:BoundingStructure, b:BoundingStructure, out:ClosestPoints):void
        {
            KERNELS[int(KINDS * a.kind + b.kind)].findClosest(a, b, out);
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
            addPair(kernels, BoundingStructure.SPHERE, BoundingStructure.CAPSULE, new RoundKernel(new SphereCapsuleGapFinder(), convex));
            addPair(kernels, BoundingStructure.SPHERE, BoundingStructure.BOX, new RoundKernel(new SphereBoxGapFinder(), convex));
            addPair(kernels, BoundingStructure.CAPSULE, BoundingStructure.CAPSULE, new RoundKernel(new CapsuleCapsuleGapFinder(), convex));
            addPair(kernels, BoundingStructure.CAPSULE, BoundingStructure.BOX, new RoundKernel(new CapsuleBoxGapFinder(), convex));
            addPair(kernels, BoundingStructure.BOX, BoundingStructure.BOX, new BoxBoxKernel(convex));
            return kernels;
        }

        private static function addPair(kernels:Vector.<PairKernel>, a:int, b:int, kernel:PairKernel):void
        {
            kernels[KINDS * a + b] = kernel;
            if (a != b)
            {
                kernels[KINDS * b + a] = new SwappedKernel(kernel);
            }
        }
    }
}
