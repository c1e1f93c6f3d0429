package starlogo.intersection
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.convex.ClosestPoints;
    import starlogo.convex.ContactPoint;
    import starlogo.convex.RelativeMotion;
    import starlogo.engine;

    use namespace engine;

    /**
     * Decides about two structures of certain kinds. StructurePairs has a kernel for each pair of kinds: an object of a class that extends this one. This
     * class itself is the kernel of pairs with a structure of the kind OTHER, which have no answers: its methods throw.
     *
     * <p>The same two structures in the other order get the same answer, to the last bit, with the two exceptions that CorePair names. For that this
     * class puts them in an order: by their kinds, or by BoundingStructure.isAfter() if they are of one kind. A subclass answers for the first and the
     * second in that order, and so does a kernel that another one asks.</p>
     *
     * @private
     */
    public class StructurePairKernel
    {
        // The motion of b while a stands still, for the kernel that takes b first. No kernel comes back here before it has answered.
        private static const REVERSED:RelativeMotion = new RelativeMotion();

        /**
         * Finds when a moving structure first touches another one: the first moment at which <code>intersects()</code> would return true, except
         * for rounding. The motion's start and end are included. A touch between them across the margins of Touching alone may be missed.
         *
         * @param a the one that moves
         * @param b in the same space
         * @param motion the motion of a; receives the time: see RelativeMotion
         * @throws ArgumentError if the pair has no such test
         */
        public final function findTimeOfImpact(a:BoundingStructure, b:BoundingStructure, motion:RelativeMotion):void
        {
            if (!areSwapped(a, b))
            {
                findTimeOfImpactInOrder(a, b, motion);
                return;
            }
            REVERSED.setReversed(motion);
            findTimeOfImpactInOrder(b, a, REVERSED);
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
         * @param a of one of the pair's kinds
         * @param b of the other kind, in the same space
         * @param motion the motion of a; a is where it is at the motion's time
         * @param out receives the contact
         * @throws ArgumentError if the pair has no such test
         */
        public final function findContact(a:BoundingStructure, b:BoundingStructure, motion:RelativeMotion, out:ContactPoint):void
        {
            if (!areSwapped(a, b))
            {
                findContactInOrder(a, b, motion, out);
                return;
            }
            REVERSED.setReversed(motion);
            findContactInOrder(b, a, REVERSED, out);
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
         * @param a of one of the pair's kinds
         * @param b of the other kind, in the same space
         * @param out receives the distance and the points
         * @throws ArgumentError if the pair has no such test
         */
        public final function findClosest(a:BoundingStructure, b:BoundingStructure, out:ClosestPoints):void
        {
            if (!areSwapped(a, b))
            {
                findClosestInOrder(a, b, out);
                return;
            }
            findClosestInOrder(b, a, out);
            out.swap();
        }

        /** Finds the time of impact. @param motion the motion of the first; receives the time */
        internal function findTimeOfImpactInOrder(first:BoundingStructure, second:BoundingStructure, motion:RelativeMotion):void
        {
            throw missing("time of impact", first, second);
        }

        /** Finds the contact. @param motion the motion of the first, which is where it is at the motion's time */
        internal function findContactInOrder(first:BoundingStructure, second:BoundingStructure, motion:RelativeMotion, out:ContactPoint):void
        {
            throw missing("contact", first, second);
        }

        /** Finds the distance and the closest points. The first is a, and the second b. */
        internal function findClosestInOrder(first:BoundingStructure, second:BoundingStructure, out:ClosestPoints):void
        {
            throw missing("distance", first, second);
        }

        // Whether b comes first.
        private static function areSwapped(a:BoundingStructure, b:BoundingStructure):Boolean
        {
            return a.kind == b.kind ? a.isAfter(b) : a.kind > b.kind;
        }

        /** The error that says that a pair has no answer to a question. */
        public static function missing(what:String, a:BoundingStructure, b:BoundingStructure):ArgumentError
        {
            return new ArgumentError("there is no " + what + " for " + a + " and " + b);
        }
    }
}
