package starlogo.intersection
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.convex.ClosestPoints;
    import starlogo.convex.ContactPoint;
    import starlogo.convex.RelativeMotion;
    import starlogo.intersection.sweep.BoxSweep;

    /** The kernel of two boxes. The sweep finds when no axis separates them. The convex core finds the contact and the distance. */
    internal final class BoxBoxKernel extends PairKernel
    {
        private var _sweep:BoxSweep = new BoxSweep();
        private var _convex:ConvexKernel;

        // the motion of a box that stands still
        private var _standing:RelativeMotion = new RelativeMotion();

        /** @param convex finds the contact and the distance */
        public function BoxBoxKernel(convex:ConvexKernel)
        {
            _convex = convex;
        }

        /** Whether two boxes touch or overlap, by the sweep's axes. They do not cancel if edges are nearly parallel: see boxBox. */
        override public function areTouching(a:BoundingStructure, b:BoundingStructure):Boolean
        {
            findTime(a, b, _standing);
            return _standing.time == 0;
        }

        /** @inheritDoc */
        override public function findTime(a:BoundingStructure, b:BoundingStructure, motion:RelativeMotion):void
        {
            _sweep.findTime(a as Box, b as Box, motion);
        }

        /** @inheritDoc */
        override public function findContact(a:BoundingStructure, b:BoundingStructure, displacement:RelativeMotion, out:ContactPoint):void
        {
            _convex.findOverlap(a, b, displacement, out);
        }

        /** @inheritDoc */
        override public function findClosest(a:BoundingStructure, b:BoundingStructure, out:ClosestPoints):void
        {
            _convex.findClosest(a, b, out);
        }
    }
}
