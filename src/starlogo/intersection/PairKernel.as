package starlogo.intersection
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.convex.ClosestPoints;
    import starlogo.convex.ContactPoint;
    import starlogo.convex.RelativeMotion;

    /**
     * The kernel of a pair of kinds: it tests, sweeps and measures two structures. PairTable has the kernel of each pair. This class is the
     * kernel of pairs that have no such operations, so all of its methods throw.
     *
     * @private
     */
    public class PairKernel
    {
        /**
         * Whether two structures touch or overlap. The function <code>intersects()</code> is faster: it calls the function of a pair of spheres,
         * capsules and boxes at once.
         *
         * @param a of the pair's first kind
         * @param b of the pair's second kind, in the same space
         * @throws ArgumentError if the pair has no such test
         */
        public function areTouching(a:BoundingStructure, b:BoundingStructure):Boolean
        {
            throw missing("intersection test", a, b);
        }

        /**
         * Finds when a moving structure first touches another one, and sets the motion's time to it.
         *
         * @param a of the pair's first kind
         * @param b of the pair's second kind, in the same space
         * @param motion the motion of a; receives the time
         * @throws ArgumentError if the pair has no such test
         */
        public function findTime(a:BoundingStructure, b:BoundingStructure, motion:RelativeMotion):void
        {
            throw missing("time of impact", a, b);
        }

        /**
         * Finds where two structures touch, or how they overlap.
         *
         * @param a of the pair's first kind
         * @param b of the pair's second kind, in the same space
         * @param displacement moves a from its stored place to the motion's start; its other numbers are 0
         * @param out receives the contact
         * @throws ArgumentError if the pair has no such test
         */
        public function findContact(a:BoundingStructure, b:BoundingStructure, displacement:RelativeMotion, out:ContactPoint):void
        {
            throw missing("contact", a, b);
        }

        /**
         * Finds the distance of two structures, and their closest points.
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

        private static function missing(what:String, a:BoundingStructure, b:BoundingStructure):ArgumentError
        {
            return new ArgumentError("there is no " + what + " for " + a + " and " + b);
        }
    }
}
