package starlogo.intersection
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.intersection.contact.ContactPoint;
    import starlogo.intersection.distance.ClosestPair;
    import starlogo.intersection.sweep.RelativeMotion;

    /**
     * What the sweep, the contact and the distance of one pair of kinds are made from; PairTable has one for each. This one is for pairs without a test.
     *
     * @private
     */
    public class PairKernel
    {
        /** It has no state. */
        public function PairKernel()
        {
        }

        /**
         * Finds when a structure that moves touches another for the first time: the motion's time.
         *
         * @param a of the pair's first kind
         * @param b of the pair's second kind, in the same space
         * @param motion of a, which takes the time
         * @throws ArgumentError when there is no test for the pair
         */
        public function findTime(a:BoundingStructure, b:BoundingStructure, motion:RelativeMotion):void
        {
            throw missing(a, b);
        }

        /**
         * Where two structures touch, or how they overlap.
         *
         * @param a of the pair's first kind
         * @param b of the pair's second kind, in the same space
         * @param displacement where a is, from where it stands: the motion's start
         * @param out takes the contact
         * @throws ArgumentError when there is no test for the pair
         */
        public function findContact(a:BoundingStructure, b:BoundingStructure, displacement:RelativeMotion, out:ContactPoint):void
        {
            throw missing(a, b);
        }

        /**
         * How far two structures are apart, and between which points.
         *
         * @param a of the pair's first kind
         * @param b of the pair's second kind, in the same space
         * @param out takes it
         * @throws ArgumentError when there is no test for the pair
         */
        public function findClosest(a:BoundingStructure, b:BoundingStructure, out:ClosestPair):void
        {
            throw missing(a, b);
        }

        private static function missing(a:BoundingStructure, b:BoundingStructure):ArgumentError
        {
            return new ArgumentError("there is no test of motion, no contact and no distance for " + a + " and " + b);
        }
    }
}
