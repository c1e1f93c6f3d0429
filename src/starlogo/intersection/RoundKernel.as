package starlogo.intersection
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.convex.ClosestPoints;
    import starlogo.convex.ConservativeAdvancement;
    import starlogo.convex.ContactPoint;
    import starlogo.convex.CoreGap;
    import starlogo.convex.RelativeMotion;
    import starlogo.geometry.Tolerances;

    /**
     * The kernel of two structures of which at least one is a sphere or a capsule, except for two spheres. It answers by the gap between their cores
     * and the radii. The GapFinder finds the gap. If there is hardly any, the ConvexPairKernel finds the contact.
     *
     * <p>The steps to the time of impact are those of all convex shapes: see ConservativeAdvancement. Here a formula gives the gap of each. With hardly any
     * radius the last gaps are so short that rounding hides their direction, so the ConvexPairKernel finds the time.</p>
     *
     * @private
     */
    public final class RoundKernel extends StructurePairKernel
    {
        private var _convex:ConvexPairKernel;
        private var _finder:GapFinder = new GapFinder();
        private var _gap:CoreGap = new CoreGap();
        private var _step:ConservativeAdvancement = new ConservativeAdvancement();

        /** @param convex finds the contact if there is hardly any gap, and the time of impact if there is hardly any radius */
        public function RoundKernel(convex:ConvexPairKernel)
        {
            _convex = convex;
        }

        /** @inheritDoc */
        override internal function findTimeOfImpactInOrder(first:BoundingStructure, second:BoundingStructure, motion:RelativeMotion):void
        {
            var gap:CoreGap = _gap;
            var step:ConservativeAdvancement = _step;
            var margins:Number = motion.margin;
            motion.time = 0;
            step.reset();
            do
            {
                _finder.find(first, second, motion, gap);
                var radii:Number = gap.radiusA + gap.radiusB;
                var touchingDistance:Number = radii * Tolerances.TOUCHING + margins;
                var length:Number = Math.sqrt(gap.squaredLength);
                step.isTouching = gap.squaredLength <= touchingDistance * touchingDistance;
                if (!step.isTouching && radii < Tolerances.DIRECTION * gap.size)
                {
                    _convex.findTimeOfImpactInOrder(first, second, motion);
                    return;
                }
                step.separation = length - radii;
                step.speed = gap.closingSpeedTimesLength / length;
            }
            while (step.advance(motion));
        }

        /** @inheritDoc */
        override internal function findContactInOrder(first:BoundingStructure, second:BoundingStructure, motion:RelativeMotion, out:ContactPoint):void
        {
            var gap:CoreGap = _gap;
            _finder.findCentered(first, second, motion, gap);
            // If the gap is longer than this, it has a direction in spite of rounding.
            var least:Number = Tolerances.DIRECTION * gap.size;
            if (gap.squaredLength > least * least)
            {
                out.setFromGap(gap, motion);
            }
            else if (gap.squaredLength == 0)
            {
                _convex.findOverlapInOrder(first, second, motion, out);
            }
            else
            {
                _convex.findContactInOrder(first, second, motion, out);
            }
        }

        /** @inheritDoc */
        override internal function findClosestInOrder(first:BoundingStructure, second:BoundingStructure, out:ClosestPoints):void
        {
            _finder.find(first, second, RelativeMotion.NONE, _gap);
            out.setFromGap(_gap);
        }
    }
}
