package starlogo.intersection
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.convex.ClosestPoints;
    import starlogo.convex.ContactPoint;
    import starlogo.convex.ConvexKernel;
    import starlogo.convex.ConvexShape;
    import starlogo.convex.RelativeMotion;
    import starlogo.engine;
    import starlogo.intersection.boxes.BoxSweep;

    use namespace engine;

    /**
     * Answers for any two convex structures. It makes shapes of the two, about which ConvexKernel decides. StructurePairs has it for pairs with a hull and
     * for two boxes, and RoundKernel asks it where it does not answer itself. It sets both shapes in each call, which takes little time because the
     * shape of a hull shares the lists of the hull. The time of impact of two boxes comes from BoxSweep, which is faster.
     *
     * @private
     */
    public final class ConvexPairKernel extends StructurePairKernel
    {
        private var _kernel:ConvexKernel = new ConvexKernel();
        private var _boxSweep:BoxSweep = new BoxSweep();
        private var _a:ConvexShape = new ConvexShape();
        private var _b:ConvexShape = new ConvexShape();

        /** Whether two structures touch. */
        public function areTouching(a:BoundingStructure, b:BoundingStructure):Boolean
        {
            setShapes(a, b);
            return _kernel.areTouching(_a, _b);
        }

        /** @inheritDoc */
        override internal function findTimeOfImpactInOrder(first:BoundingStructure, second:BoundingStructure, motion:RelativeMotion):void
        {
            if (areBoxes(first, second))
            {
                _boxSweep.findTimeOfImpactOfBoxes(first as Box, second as Box, motion);
                return;
            }
            setShapes(first, second);
            _kernel.findTimeOfImpact(_a, _b, motion);
        }

        /** @inheritDoc */
        override internal function findContactInOrder(first:BoundingStructure, second:BoundingStructure, motion:RelativeMotion, out:ContactPoint):void
        {
            if (areBoxes(first, second))
            {
                // also if they touch across a margin: StructurePairKernel promises a normal of a face or across two edges
                findOverlapInOrder(first, second, motion, out);
                return;
            }
            setShapes(first, second);
            _kernel.findContact(_a, _b, motion, out);
        }

        /** Finds the contact of two structures whose cores overlap. It is faster than <code>findContactInOrder()</code>. */
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

        /** Whether two structures are boxes. */
        internal static function areBoxes(a:BoundingStructure, b:BoundingStructure):Boolean
        {
            return a.kind == BoundingStructure.BOX && b.kind == BoundingStructure.BOX;
        }

        private function setShapes(a:BoundingStructure, b:BoundingStructure):void
        {
            a.setShape(_a);
            b.setShape(_b);
        }
    }
}
