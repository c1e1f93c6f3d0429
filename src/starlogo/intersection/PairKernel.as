package starlogo.intersection
{
    import flash.errors.IllegalOperationError;
    import starlogo.bounding.BoundingStructure;
    import starlogo.intersection.contact.ContactPoint;
    import starlogo.intersection.sweep.RelativeMotion;

    /** What the sweep and the contact of one pair of kinds are made from; PairTable has one for each. Abstract. */
    public class PairKernel
    {
        /** For subclasses only. */
        public function PairKernel()
        {
        }

        /**
         * When a structure that moves touches another for the first time.
         *
         * @param a of the pair's first kind
         * @param b of the pair's second kind, in the same space
         * @param motion of a
         * @return from 0 to 1, or RelativeMotion.NEVER
         */
        public function timeOfImpact(a:BoundingStructure, b:BoundingStructure, motion:RelativeMotion):Number
        {
            throw new IllegalOperationError("abstract");
        }

        /**
         * Where two structures touch, or how they overlap.
         *
         * @param a of the pair's first kind
         * @param b of the pair's second kind, in the same space
         * @param displacement where a is, from where it stands: the motion's start
         * @param out takes the contact
         */
        public function findContact(a:BoundingStructure, b:BoundingStructure, displacement:RelativeMotion, out:ContactPoint):void
        {
            throw new IllegalOperationError("abstract");
        }
    }
}
