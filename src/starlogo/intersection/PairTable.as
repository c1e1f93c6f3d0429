package starlogo.intersection
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.bounding.Capsule;
    import starlogo.bounding.Sphere;
    import starlogo.convex.ClosestPoints;
    import starlogo.convex.ContactPoint;
    import starlogo.convex.RelativeMotion;

    /**
     * Says how two structures meet: whether they touch, when a moving one first touches the other, how they overlap, and how far apart they are.
     * This class alone chooses what answers for two kinds: a function tests whether they touch, and a kernel finds the rest. The package is made of
     * these, a TriangleKernel for a shape and triangles, and the tests of two boxes (<code>boxes</code>) and of rays (<code>ray</code>). Read
     * PairKernel next, which explains the questions, then RoundKernel and SphereBoxGapFinder.
     *
     * <p>Spheres, capsules and boxes have kernels of their own, because the package convex takes two to eleven times as long. That package decides
     * about hulls. It also finds the distance of two boxes and their contact, and what RoundKernel leaves to it: the contact if cores overlap, and the
     * time of impact if there is hardly any radius.</p>
     *
     * @private
     */
    public final class PairTable
    {
        private static const KINDS:int = BoundingStructure.OTHER + 1;

        private static const CONVEX:ConvexPairKernel = new ConvexPairKernel();

        // For each pair of kinds its kernel: a row for each kind of a. Only pairs count whose second kind is not below the first.
        private static const KERNELS:Vector.<PairKernel> = makeKernels();

        // For a pair whose second kind is below the first: the kernel is asked about b and a, and this is the motion of b.
        private static const REVERSED:RelativeMotion = new RelativeMotion();

        /**
         * Whether two structures touch or overlap. Touching counts: see Touching. Games call it as <code>intersects()</code>.
         *
         * @throws ArgumentError if the pair has no such test
         */
        public static function areTouching(a:BoundingStructure, b:BoundingStructure):Boolean
        {
            var kindA:int = a.kind;
            var kindB:int = b.kind;
            if (kindA > kindB)
            {
                var first:BoundingStructure = b;
                b = a;
                a = first;
                kindA = a.kind;
                kindB = b.kind;
            }
            // The tests are short, and calls take long in Adobe's VM. So no kernel stands between.
            switch (kindB)
            {
                case BoundingStructure.SPHERE:
                    return sphereSphere(a as Sphere, b as Sphere);
                case BoundingStructure.CAPSULE:
                    return kindA == BoundingStructure.SPHERE ? sphereCapsule(a as Sphere, b as Capsule) : capsuleCapsule(a as Capsule, b as Capsule);
                case BoundingStructure.BOX:
                    return kindA == BoundingStructure.SPHERE ? sphereBox(a as Sphere, b as Box)
                        : kindA == BoundingStructure.CAPSULE ? capsuleBox(a as Capsule, b as Box) : boxBox(a as Box, b as Box);
                case BoundingStructure.HULL:
                    return CONVEX.areTouching(a, b);
                default:
                    throw PairKernel.missing("intersection test", a, b);
            }
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
            var missing:PairKernel = new PairKernel();
            for (var kind:int = 0; kind < KINDS; kind++)
            {
                kernels[KINDS * kind + BoundingStructure.HULL] = CONVEX;
                kernels[KINDS * kind + BoundingStructure.OTHER] = missing;
            }
            var ofSphere:int = KINDS * BoundingStructure.SPHERE;
            kernels[ofSphere + BoundingStructure.SPHERE] = new SphereSphereKernel();
            kernels[ofSphere + BoundingStructure.CAPSULE] = new RoundKernel(new SegmentGapFinder(), CONVEX);
            kernels[ofSphere + BoundingStructure.BOX] = new RoundKernel(new SphereBoxGapFinder(), CONVEX);
            var ofCapsule:int = KINDS * BoundingStructure.CAPSULE;
            kernels[ofCapsule + BoundingStructure.CAPSULE] = new RoundKernel(new SegmentGapFinder(), CONVEX);
            kernels[ofCapsule + BoundingStructure.BOX] = new RoundKernel(new CapsuleBoxGapFinder(), CONVEX);
            kernels[KINDS * BoundingStructure.BOX + BoundingStructure.BOX] = new BoxBoxKernel(CONVEX);
            return kernels;
        }
    }
}
