package starlogo.intersection
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.convex.ClosestPoints;
    import starlogo.convex.ContactPoint;
    import starlogo.convex.ConvexPair;
    import starlogo.convex.ConvexShape;
    import starlogo.convex.RelativeMotion;
    import starlogo.intersection.contact.LeastOverlap;
    import starlogo.intersection.sweep.BoxSweep;

    /**
     * The kernel of two boxes. It uses separating axes. The sweep finds when no axis separates the boxes. The contact finds the axis along
     * which they overlap least. The convex core finds the distance.
     */
    internal final class BoxBoxKernel extends PairKernel
    {
        private var _sweep:BoxSweep = new BoxSweep();

        // the motion of a box that stands still
        private var _standing:RelativeMotion = new RelativeMotion();

        private var _overlap:LeastOverlap = new LeastOverlap();

        // For the distance, which is that of two convex shapes.
        private var _pair:ConvexPair = new ConvexPair();
        private var _a:ConvexShape = new ConvexShape();
        private var _b:ConvexShape = new ConvexShape();

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
            _overlap.findContact(a, b, displacement, out);
        }

        /** @inheritDoc */
        override public function findClosest(a:BoundingStructure, b:BoundingStructure, out:ClosestPoints):void
        {
            _a.setBox(a as Box);
            _b.setBox(b as Box);
            _pair.findClosest(_a, _b, out);
        }
    }
}
