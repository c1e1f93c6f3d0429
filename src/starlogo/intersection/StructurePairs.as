// The package intersection says how two bounding structures meet, for each pair of their kinds, or a structure and a ray. It is made of functions that
// test whether two touch, of kernels that find the rest, of a TriangleKernel for a shape and triangles, and of the tests of two boxes (boxes) and of
// rays (ray). Read StructurePairs first, then StructurePairKernel, which explains the questions, then RoundKernel.

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
     * This class alone chooses what answers for two kinds: a function tests whether they touch, and a kernel finds the rest.
     *
     * <p>Spheres, capsules and boxes have kernels of their own, because the package convex takes two to eleven times as long. That package decides
     * about hulls. It also finds the distance of two boxes and their contact, and what RoundKernel leaves to it: the contact if there is hardly any gap,
     * and the time of impact if there is hardly any radius.</p>
     *
     * @private
     */
    public final class StructurePairs
    {
        private static const CONVEX:ConvexPairKernel = new ConvexPairKernel();
        private static const ROUND:RoundKernel = new RoundKernel(CONVEX);

        // The kernel of two kinds, by the later one in the order SPHERE, CAPSULE, BOX, HULL, OTHER. Only two boxes have another one.
        private static const KERNELS:Vector.<StructurePairKernel> = new <StructurePairKernel>[
                new SphereSphereKernel(), ROUND, ROUND, CONVEX, new StructurePairKernel()];

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
                    throw StructurePairKernel.missing("intersection test", a, b);
            }
        }

        /** Finds when a moving structure first touches another one. See StructurePairKernel. */
        public static function findTimeOfImpact(a:BoundingStructure, b:BoundingStructure, motion:RelativeMotion):void
        {
            kernelOf(a, b).findTimeOfImpact(a, b, motion);
        }

        /** Finds where two structures touch, or how they overlap. See StructurePairKernel. */
        public static function findContact(a:BoundingStructure, b:BoundingStructure, motion:RelativeMotion, out:ContactPoint):void
        {
            kernelOf(a, b).findContact(a, b, motion, out);
        }

        /** Finds the distance of two structures and their closest points. See StructurePairKernel. */
        public static function findClosest(a:BoundingStructure, b:BoundingStructure, out:ClosestPoints):void
        {
            kernelOf(a, b).findClosest(a, b, out);
        }

        private static function kernelOf(a:BoundingStructure, b:BoundingStructure):StructurePairKernel
        {
            var later:int = a.kind > b.kind ? a.kind : b.kind;
            return ConvexPairKernel.areBoxes(a, b) ? CONVEX : KERNELS[later];
        }
    }
}
