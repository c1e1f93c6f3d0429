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
     * PairKernel next, which explains the questions, then RoundKernel and GapFinder.
     *
     * <p>Spheres, capsules and boxes have kernels of their own, because the package convex takes two to eleven times as long. That package decides
     * about hulls. It also finds the distance of two boxes and their contact, and what RoundKernel leaves to it: the contact if cores overlap, and the
     * time of impact if there is hardly any radius.</p>
     *
     * @private
     */
    public final class PairTable
    {
        // The numbers of the kinds are in this order: SPHERE, CAPSULE, BOX, HULL, OTHER. Of two kinds, the later one chooses the kernel.
        private static const KINDS:int = BoundingStructure.OTHER + 1;

        private static const CONVEX:ConvexPairKernel = new ConvexPairKernel();

        // The kernels by the kinds of a and b: a row for each kind of a.
        private static const KERNELS:Vector.<PairKernel> = makeKernels();

        /**
         * Whether two structures touch or overlap. Touching counts: see Touching. Games call it as <code>intersects()</code>.
         *
         * @throws ArgumentError if the pair has no such test
         */
        public static function areTouching(a:BoundingStructure, b:BoundingStructure):Boolean
        {
            var kindA:int = a.kind;
            if (kindA > b.kind)
            {
                return areTouching(b, a);
            }
            // The tests are short, and calls take long in Adobe's VM. So no kernel stands between.
            switch (b.kind)
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
            kernelOf(a, b).findTime(a, b, motion);
        }

        /** Finds where two structures touch, or how they overlap. See PairKernel. */
        public static function findContact(a:BoundingStructure, b:BoundingStructure, motion:RelativeMotion, out:ContactPoint):void
        {
            kernelOf(a, b).findContact(a, b, motion, out);
        }

        /** Finds the distance of two structures and their closest points. See PairKernel. */
        public static function findClosest(a:BoundingStructure, b:BoundingStructure, out:ClosestPoints):void
        {
            kernelOf(a, b).findClosest(a, b, out);
        }

        private static function kernelOf(a:BoundingStructure, b:BoundingStructure):PairKernel
        {
            return KERNELS[int(KINDS * a.kind + b.kind)];
        }

        private static function makeKernels():Vector.<PairKernel>
        {
            var kernels:Vector.<PairKernel> = new Vector.<PairKernel>(KINDS * KINDS, true);
            var round:PairKernel = new RoundKernel(CONVEX);
            fill(kernels, BoundingStructure.CAPSULE, round);
            fill(kernels, BoundingStructure.BOX, round);
            fill(kernels, BoundingStructure.HULL, CONVEX);
            fill(kernels, BoundingStructure.OTHER, new PairKernel());
            kernels[KINDS * BoundingStructure.SPHERE + BoundingStructure.SPHERE] = new SphereSphereKernel();
            kernels[KINDS * BoundingStructure.BOX + BoundingStructure.BOX] = CONVEX;
            return kernels;
        }

        // Sets the kernel of a kind with itself and with each kind below it.
        private static function fill(kernels:Vector.<PairKernel>, kind:int, kernel:PairKernel):void
        {
            for (var other:int = 0; other <= kind; other++)
            {
                kernels[KINDS * kind + other] = kernels[KINDS * other + kind] = kernel;
            }
        }
    }
}
