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
    import starlogo.intersection.boxes.BoxPair;
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
        private var _boxes:BoxPair = new BoxPair();
        private var _a:ConvexShape = new ConvexShape();
        private var _b:ConvexShape = new ConvexShape();

        /** Whether two structures touch. */
        public function areTouching(a:BoundingStructure, b:BoundingStructure):Boolean
        {
            setShapes(a, b);
            return _kernel.areTouching(_a, _b);
        }

        /** @inheritDoc */
        override public function findTimeOfImpact(a:BoundingStructure, b:BoundingStructure, motion:RelativeMotion):void
        {
            if (areBoxes(a, b))
            {
                _boxes.setMoving(a as Box, b as Box, motion);
                _boxSweep.findTimeOfImpact(_boxes, motion);
                return;
            }
            setShapes(a, b);
            _kernel.findTimeOfImpact(_a, _b, motion);
        }

        /** @inheritDoc */
        override public function findContact(a:BoundingStructure, b:BoundingStructure, motion:RelativeMotion, out:ContactPoint):void
        {
            if (areBoxes(a, b))
            {
                // also if they touch across a margin: StructurePairs promises a normal of a face or across two edges
                findOverlap(a, b, motion, out);
                return;
            }
            setShapes(a, b);
            _kernel.findContact(_a, _b, motion, out);
        }

        /** Finds the contact of two structures whose cores overlap. It is faster than <code>findContact()</code>. */
        internal function findOverlap(a:BoundingStructure, b:BoundingStructure, motion:RelativeMotion, out:ContactPoint):void
        {
            setShapes(a, b);
            _kernel.findOverlap(_a, _b, motion, out);
        }

        /** @inheritDoc */
        override public function findClosest(a:BoundingStructure, b:BoundingStructure, out:ClosestPoints):void
        {
            setShapes(a, b);
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
