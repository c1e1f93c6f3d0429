package starlogo.intersection
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.convex.ClosestPoints;
    import starlogo.convex.ContactPoint;
    import starlogo.convex.ConvexKernel;
    import starlogo.convex.ConvexShape;
    import starlogo.convex.RelativeMotion;
    import starlogo.engine;

    use namespace engine;

    /**
     * Answers for any two convex structures. It makes shapes of the two, about which ConvexKernel decides. PairTable has it for pairs with a hull,
     * and other kernels ask it where they do not answer themselves. It sets both shapes in each call, which takes little time because the shape of a
     * hull shares the lists and the extent of the hull.
     *
     * @private
     */
    public final class ConvexPairKernel extends PairKernel
    {
        private var _kernel:ConvexKernel = new ConvexKernel();
        private var _a:ConvexShape = new ConvexShape();
        private var _b:ConvexShape = new ConvexShape();

        /** Whether two structures touch. If simpler structures stand around them, these are tested first. */
        public function areTouching(a:BoundingStructure, b:BoundingStructure):Boolean
        {
            var aroundA:BoundingStructure = a.around;
            var aroundB:BoundingStructure = b.around;
            if ((aroundA !== a || aroundB !== b) && !PairTable.areTouching(aroundA, aroundB))
            {
                return false;
            }
            setShapes(a, b);
            return _kernel.areTouching(_a, _b);
        }

        /** @inheritDoc */
        override internal function findTimeInOrder(first:BoundingStructure, second:BoundingStructure, motion:RelativeMotion):void
        {
            setShapes(first, second);
            _kernel.findTime(_a, _b, motion);
        }

        /** @inheritDoc */
        override internal function findContactInOrder(first:BoundingStructure, second:BoundingStructure, motion:RelativeMotion, out:ContactPoint):void
        {
            setShapes(first, second);
            _kernel.findContact(_a, _b, motion, out);
        }

        /** Finds the contact of two structures whose cores touch or overlap. It is faster than <code>findContactInOrder()</code>. */
        internal function findOverlapInOrder(first:BoundingStructure, second:BoundingStructure, motion:RelativeMotion, out:ContactPoint):void
        {
            setShapes(first, second);
            _kernel.findOverlap(_a, _b, motion, out);
        }

        /** @inheritDoc */
        override internal function findClosestInOrder(first:BoundingStructure, second:BoundingStructure, out:ClosestPoints):void
        {
            setShapes(first, second);
            _kernel.findClosest(_a, _b, out);
        }

        private function setShapes(a:BoundingStructure, b:BoundingStructure):void
        {
            a.shapeInto(_a);
            b.shapeInto(_b);
        }
    }
}
