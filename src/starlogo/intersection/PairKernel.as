package starlogo.intersection
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.convex.ClosestPoints;
    import starlogo.convex.ContactPoint;
    import starlogo.convex.RelativeMotion;

    /**
     * Decides about two structures of certain kinds. PairTable has a kernel for each pair of kinds: an object of a class that extends this one. This
     * class itself is the kernel of pairs with a structure of the kind OTHER, which have no answers: its methods throw.
     *
     * @private
     */
    public class PairKernel
    {
        /**
         * Finds when a moving structure first touches another one: the first moment at which <code>intersects()</code> would return true, except
         * for rounding. The motion's start and end are included.
         *
         * @param a of the pair's first kind, which moves
         * @param b of the pair's second kind, in the same space
         * @param motion the motion of a; receives the time: see RelativeMotion
         * @throws ArgumentError if the pair has no such test
         */
        public function findTime(a:BoundingStructure, b:BoundingStructure, motion:RelativeMotion):void
        {
            throw missing("time of impact", a, b);
        }

        /**
         * Finds where two structures touch, or how they overlap.
         *
         * <p>The normal is the direction of the shortest displacement that separates a from b. The depth is its length: after that displacement the
         * two just touch. The point is in the middle of the overlap along the normal. If two boxes touch along an edge or a face, it is in the
         * middle of that edge or face too. The same holds for a box and a capsule's axis inside of it. The result is exact except for rounding.</p>
         *
         * <p>A structure's core is a sphere's centre, a capsule's axis, or a whole box or hull. If the cores are apart, the normal is along the line
         * between their closest points. If they overlap, and for two boxes, the normal is perpendicular to a face of one or to an edge of each:
         * the direction along which they overlap least (Gottschalk, Lin and Manocha, "OBBTree", 1996).</p>
         *
         * <p>If several displacements are equally short, one is chosen. Spheres with the same centre separate along z. If a sphere's centre is on a
         * capsule's axis, or the axes of two capsules overlap on one line, the normal is perpendicular to the axis and points upwards as far as
         * possible. In the middle of a box any face is chosen. Of two opposite displacements it is the one against the motion, if the motion's time
         * is above 0.</p>
         *
         * @param a of the pair's first kind
         * @param b of the pair's second kind, in the same space
         * @param motion the motion of a; a is where it is at the motion's time
         * @param out receives the contact
         * @throws ArgumentError if the pair has no such test
         */
        public function findContact(a:BoundingStructure, b:BoundingStructure, motion:RelativeMotion, out:ContactPoint):void
        {
            throw missing("contact", a, b);
        }

        /**
         * Finds the distance of two structures and their closest points. If the structures overlap, the distance is 0, and both points are one
         * point inside of both.
         *
         * <p>The result is exact except for rounding, which is 1e-15 of their extents and of the distance. So structures that just touch may have
         * a distance as small as that. Symmetric to the last bit.</p>
         *
         * @param a of the pair's first kind
         * @param b of the pair's second kind, in the same space
         * @param out receives the distance and the points
         * @throws ArgumentError if the pair has no such test
         */
        public function findClosest(a:BoundingStructure, b:BoundingStructure, out:ClosestPoints):void
        {
            throw missing("distance", a, b);
        }

        /** The error that says that a pair has no answer to a question. */
        public static function missing(what:String, a:BoundingStructure, b:BoundingStructure):ArgumentError
        {
            return new ArgumentError("there is no " + what + " for " + a + " and " + b);
        }
    }
}
