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
    import starlogo.intersection.sweep.findBoxImpact;

    /**
     * The kernel of two boxes. It uses separating axes. The sweep finds when no axis separates the boxes. The contact finds the axis along
     * which they overlap least. The convex core finds the distance.
     */
    internal final class BoxBoxKernel extends PairKernel
    {
        private var _overlap:LeastOverlap = new LeastOverlap();

        // For the distance, which is that of two convex shapes.
        private var _pair:ConvexPair = new ConvexPair();
        private var _a:ConvexShape = new ConvexShape();
        private var _b:ConvexShape = new ConvexShape();

        /** @inheritDoc */
        override public function findTime(a:BoundingStructure, b:BoundingStructure, motion:RelativeMotion):void
        {
            findBoxImpact(a as Box, b as Box, motion);
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
