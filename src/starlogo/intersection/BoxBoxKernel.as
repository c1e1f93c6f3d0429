package starlogo.intersection
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.convex.ContactPoint;
    import starlogo.convex.RelativeMotion;
    import starlogo.intersection.boxes.BoxSweep;

    /** The kernel of two boxes. BoxSweep finds the time of impact. */
    internal final class BoxBoxKernel extends ConvexPairKernel
    {
        private var _sweep:BoxSweep = new BoxSweep();

        /** @inheritDoc */
        override public function findTime(a:BoundingStructure, b:BoundingStructure, motion:RelativeMotion):void
        {
            _sweep.findTimeOfBoxes(a as Box, b as Box, motion);
        }

        /** @inheritDoc */
        override public function findContact(a:BoundingStructure, b:BoundingStructure, motion:RelativeMotion, out:ContactPoint):void
        {
            findOverlap(a, b, motion, out);
        }
    }
}
