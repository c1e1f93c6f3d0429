package starlogo.intersection
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.intersection.contact.ContactPoint;
    import starlogo.intersection.contact.DeepContact;
    import starlogo.intersection.sweep.RelativeMotion;
    import starlogo.intersection.sweep.boxBoxImpact;

    /** The kernel of two boxes: separating axes, over time and for the shortest of all overlaps. */
    internal final class BoxPair extends PairKernel
    {
        private static const DEEP:DeepContact = new DeepContact();

        /** It has no state. */
        public function BoxPair()
        {
        }

        /** @inheritDoc */
        override public function timeOfImpact(a:BoundingStructure, b:BoundingStructure, motion:RelativeMotion):Number
        {
            return boxBoxImpact(a as Box, b as Box, motion);
        }

        /** @inheritDoc */
        override public function findContact(a:BoundingStructure, b:BoundingStructure, displacement:RelativeMotion, out:ContactPoint):void
        {
            DEEP.find(a, b, 0, displacement.startX, displacement.startY, displacement.startZ, out);
        }
    }
}
