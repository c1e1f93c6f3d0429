package starlogo.intersection
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.convex.ClosestPoints;
    import starlogo.convex.ContactPoint;
    import starlogo.convex.RelativeMotion;
    import starlogo.intersection.boxes.BoxSweep;

    /** The kernel of two boxes. BoxSweep finds the time of impact. The ConvexPairKernel finds the contact and the distance. */
    internal final class BoxBoxKernel extends PairKernel
    {
        private var _sweep:BoxSweep = new BoxSweep();
        private var _convex:ConvexPairKernel;

        /** @param convex finds the contact and the distance */
        public function BoxBoxKernel(convex:ConvexPairKernel)
        {
            _convex = convex;
        }

        /** @inheritDoc */
        override public function findTime(a:BoundingStructure, b:BoundingStructure, motion:RelativeMotion):void
        {
            _sweep.findTimeOfBoxes(a as Box, b as Box, motion);
        }

        /** @inheritDoc */
        override public function findContact(a:BoundingStructure, b:BoundingStructure, motion:RelativeMotion, out:ContactPoint):void
        {
            _convex.findOverlap(a, b, motion, out);
        }

        /** @inheritDoc */
        override public function findClosest(a:BoundingStructure, b:BoundingStructure, out:ClosestPoints):void
        {
            _convex.findClosest(a, b, out);
        }
    }
}
