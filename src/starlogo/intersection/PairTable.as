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
     * Here alone it is decided which kernel answers for two kinds. The package is made of a kernel for each pair of kinds, a TriangleKernel for a
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

        // For each pair of kinds its kernel: a row for each kind of a. Only pairs count whose second kind is not below the first.
        // areTouching() reads it itself, because its tests are short, and calls take long in Adobe's VM.
        private static const KERNELS:Vector.<PairKernel> = makeKernels();

        // For a pair whose second kind is below the first: the kernel is asked about b and a, and this is the motion of b.
        private static const REVERSED:RelativeMotion = new RelativeMotion();

        /** Whether two structures touch or overlap. See PairKernel. Games call it as <code>intersects()</code>. */
        public static function areTouching(a:BoundingStructure, b:BoundingStructure):Boolean
        {
            return a.kind <= b.kind ? KERNELS[int(KINDS * a.kind + b.kind)].areTouching(a, b) : KERNELS[int(KINDS * b.kind + a.kind)].areTouching(b, a);
        }

        /** Finds when a moving structure first touches another one. See PairKernel. */
        public static function findTime(a:BoundingStructure, b:BoundingStructure, motion:RelativeMotion):void
        {
            if (a.kind <= b.kind)
            {
                kernelOf(a, b).findTime(a, b, motion);
                return;
            }
            REVERSED.setReversed(motion);
            kernelOf(b, a).findTime(b, a, REVERSED);
            motion.time = REVERSED.time;
        }

        /** Finds where two structures touch, or how they overlap. See PairKernel. */
        public static function findContact(a:BoundingStructure, b:BoundingStructure, motion:RelativeMotion, out:ContactPoint):void
        {
            if (a.kind <= b.kind)
            {
                kernelOf(a, b).findContact(a, b, motion, out);
                return;
            }
            REVERSED.setReversed(motion);
            kernelOf(b, a).findContact(b, a, REVERSED, out);
            out.swap(motion);
        }

        /** Finds the distance of two structures and their closest points. See PairKernel. */
        public static function findClosest(a:BoundingStructure, b:BoundingStructure, out:ClosestPoints):void
        {
            if (a.kind <= b.kind)
            {
                kernelOf(a, b).findClosest(a, b, out);
                return;
            }
            kernelOf(b, a).findClosest(b, a, out);
            out.swap();
        }

        private static function kernelOf(a:BoundingStructure, b:BoundingStructure):PairKernel
        {
            return KERNELS[int(KINDS * a.kind + b.kind)];
        }

        private static function makeKernels():Vector.<PairKernel>
        {
            var kernels:Vector.<PairKernel> = new Vector.<PairKernel>(KINDS * KINDS, true);
            var convex:ConvexPairKernel = new ConvexPairKernel();
            var missing:PairKernel = new PairKernel();
            for (var kind:int = 0; kind < KINDS; kind++)
            {
                kernels[KINDS * kind + BoundingStructure.HULL] = convex;
                kernels[KINDS * kind + BoundingStructure.OTHER] = missing;
            }
            var ofSphere:int = KINDS * BoundingStructure.SPHERE;
            kernels[ofSphere + BoundingStructure.SPHERE] = new SphereSphereKernel();
            kernels[ofSphere + BoundingStructure.CAPSULE] = new RoundKernel(new SphereCapsuleGapFinder(), convex);
            kernels[ofSphere + BoundingStructure.BOX] = new RoundKernel(new SphereBoxGapFinder(), convex);
            var ofCapsule:int = KINDS * BoundingStructure.CAPSULE;
            kernels[ofCapsule + BoundingStructure.CAPSULE] = new RoundKernel(new CapsuleCapsuleGapFinder(), convex);
            kernels[ofCapsule + BoundingStructure.BOX] = new RoundKernel(new CapsuleBoxGapFinder(), convex);
            kernels[KINDS * BoundingStructure.BOX + BoundingStructure.BOX] = new BoxBoxKernel(convex);
            return kernels;
        }
    }
}
