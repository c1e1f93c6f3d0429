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
        override internal function findTimeInOrder(first:BoundingStructure, second:BoundingStructure, motion:RelativeMotion):void
        {
            _sweep.findTimeOfBoxes(first as Box, second as Box, motion);
        }

        /** @inheritDoc */
        override internal function findContactInOrder(first:BoundingStructure, second:BoundingStructure, motion:RelativeMotion, out:ContactPoint):void
        {
            _convex.findOverlapInOrder(first, second, motion, out);
        }

        /** @inheritDoc */
        override internal function findClosestInOrder(first:BoundingStructure, second:BoundingStructure, out:ClosestPoints):void
        {
            _convex.findClosestInOrder(first, second, out);
        }
    }
}
