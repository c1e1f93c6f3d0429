// The package intersection says how two bounding structures meet, for each pair of their kinds, or a structure and a ray. It is made of functions that
// test whether two touch, of kernels that find the rest, of a TriangleKernel for a shape and triangles, and of the tests of two boxes (boxes) and of
// rays (ray). Read StructurePairs first, which explains the questions, then RoundKernel.

package starlogo.intersection
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.bounding.Capsule;
    import starlogo.bounding.Sphere;
    import starlogo.convex.ClosestPoints;
    import starlogo.convex.ContactPoint;
    import starlogo.convex.RelativeMotion;
    import starlogo.engine;

    use namespace engine;

    /**
     * Says how two structures meet: whether they touch, when a moving one first touches the other, how they overlap, and how far apart they are.
     * This class alone chooses what answers for two kinds: a function tests whether they touch, and a kernel finds the rest.
     *
     * <p>The same two structures in the other order get the same answer, to the last bit, with the two exceptions that CorePair names. For that this
     * class puts the two in an order before it asks a kernel, and turns the answer back.</p>
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
        private static const KERNELS:Vector.<StructurePairKernel> = new <StructurePairKernel>[ROUND, ROUND, ROUND, CONVEX, new StructurePairKernel()];

        // The motion of b while a stands still, for a kernel that takes b first. No kernel comes back here before it has answered.
        private static const REVERSED:RelativeMotion = new RelativeMotion();

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

        /**
         * Finds when a moving structure first touches another one: the first moment at which <code>intersects()</code> would return true, except
         * for rounding. The motion's start and end are included. A touch between them across the margins of Touching alone may be missed.
         *
         * @param a the one that moves
         * @param b in the same space
         * @param motion the motion of a; receives the time: see RelativeMotion
         * @throws ArgumentError if the pair has no such test
         */
        public static function findTimeOfImpact(a:BoundingStructure, b:BoundingStructure, motion:RelativeMotion):void
        {
            if (!areSwapped(a, b))
            {
                kernelOf(a, b).findTimeOfImpact(a, b, motion);
                return;
            }
            REVERSED.setReversed(motion);
            kernelOf(b, a).findTimeOfImpact(b, a, REVERSED);
            motion.time = REVERSED.time;
        }

        /**
         * Finds where two structures touch, or how they overlap.
         *
         * <p>The normal is the direction of the shortest displacement that separates a from b. The depth is its length: after that displacement the
         * two just touch. The point is in the middle of the overlap along the normal. If two boxes touch along an edge or a face, it is in the
         * middle of that edge or face too. The same holds for a capsule that lies along a box or another capsule. The result is exact except for
         * rounding.</p>
         *
         * <p>A structure's core is a sphere's centre, a capsule's axis, or a whole box or hull. If the cores are apart, the normal is along the line
         * between their closest points. If they overlap, and for two boxes, the normal is perpendicular to a face of one or to an edge of each:
         * the direction along which they overlap least (Gottschalk, Lin and Manocha, "OBBTree", 1996).</p>
         *
         * <p>If several displacements are equally short, one is chosen. Spheres with the same centre separate along z. If a sphere's centre is on a
         * capsule's axis, or the axes of two capsules overlap on one line, the normal is perpendicular to the axis, and the one that comes first by
         * its place moves upwards as far as possible. In the middle of a box any face is chosen. Of two opposite displacements it is the one
         * against the motion, if the motion's time is above 0.</p>
         *
         * @param a a structure
         * @param b in the same space
         * @param motion the motion of a; a is where it is at the motion's time
         * @param out receives the contact
         * @throws ArgumentError if the pair has no such test
         */
        public static function findContact(a:BoundingStructure, b:BoundingStructure, motion:RelativeMotion, out:ContactPoint):void
        {
            if (!areSwapped(a, b))
            {
                kernelOf(a, b).findContact(a, b, motion, out);
                return;
            }
            REVERSED.setReversed(motion);
            kernelOf(b, a).findContact(b, a, REVERSED, out);
            out.swap(motion);
        }

        /**
         * Finds the distance of two structures and their closest points. If the structures overlap, the distance is 0, and both points are one
         * point inside of both.
         *
         * <p>The distance is exact except for rounding, which is 1e-15 of their extents and of the distance. So structures that just touch may have
         * a distance as small as that. Points that are farther by no more than this rounding may be found in place
         * of the closest ones.</p>
         *
         * @param a a structure
         * @param b in the same space
         * @param out receives the distance and the points
         * @throws ArgumentError if the pair has no such test
         */
        public static function findClosest(a:BoundingStructure, b:BoundingStructure, out:ClosestPoints):void
        {
            if (!areSwapped(a, b))
            {
                kernelOf(a, b).findClosest(a, b, out);
                return;
            }
            kernelOf(b, a).findClosest(b, a, out);
            out.swap();
        }

        // Whether b comes before a: by their kinds, or by their places if they are of one kind.
        private static function areSwapped(a:BoundingStructure, b:BoundingStructure):Boolean
        {
            return a.kind == b.kind ? a.isAfter(b) : a.kind > b.kind;
        }

        // The kernel of two structures in order.
        private static function kernelOf(a:BoundingStructure, b:BoundingStructure):StructurePairKernel
        {
            return ConvexPairKernel.areBoxes(a, b) ? CONVEX : KERNELS[b.kind];
        }
    }
}
