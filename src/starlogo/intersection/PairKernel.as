package starlogo.intersection
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.intersection.contact.ContactPoint;
    import starlogo.intersection.distance.DistanceResult;
    import starlogo.intersection.sweep.RelativeMotion;

    /**
     * Computes the sweep, the contact and the distance of two structures. Each pair of kinds has its own subclass, and PairTable has an
     * instance of each. Abstract.
     *
     * @private
     */
    public class PairKernel
    {
        /**
         * Finds when a moving structure first touches another one, and sets the motion's time to it.
         *
         * @param a of the pair's first kind
         * @param b of the pair's second kind, in the same space
         * @param motion the motion of a; receives the time
         */
        public function findTime(a:BoundingStructure, b:BoundingStructure, motion:RelativeMotion):void
        {
        }

        /**
         * Finds where two structures touch, or how they overlap.
         *
         * @param a of the pair's first kind
         * @param b of the pair's second kind, in the same space
         * @param displacement moves a from its stored place to the motion's start
         * @param out receives the contact
         */
        public function findContact(a:BoundingStructure, b:BoundingStructure, displacement:RelativeMotion, out:ContactPoint):void
        {
        }

        /**
         * Finds the distance of two structures, and their closest points.
         *
         * @param a of the pair's first kind
         * @param b of the pair's second kind, in the same space
         * @param out receives the distance and the points
         */
        public function findClosest(a:BoundingStructure, b:BoundingStructure, out:DistanceResult):void
        {
        }
    }
}
