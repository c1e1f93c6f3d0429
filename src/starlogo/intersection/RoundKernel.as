package starlogo.intersection
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Capsule;
    import starlogo.convex.ClosestPoints;
    import starlogo.convex.ContactPoint;
    import starlogo.convex.RelativeMotion;
    import starlogo.geometry.Tolerances;

    /**
     * The kernel of two structures of which at least one is a sphere or a capsule, except for two spheres. It answers by the gap between their cores
     * and the radii. A GapFinder finds the gap. If the cores overlap, there is no gap, and the ConvexPairKernel finds the contact.
     *
     * <p>Two cores have a distance that is a convex function of time if one moves along a straight line. So Newton's method finds the time of
     * impact (van den Bergen, "Ray casting against general convex objects with application to continuous collision detection", 2004). ConvexSweep
     * takes such steps for all other shapes. It finds the gap of each step by a search, and gets the direction of a short gap from faces and
     * edges. Here a formula gives the gap. With hardly any radius the last gaps are so short that rounding hides their direction, so the
     * ConvexPairKernel finds the time.</p>
     *
     * @private
     */
    public final class RoundKernel extends PairKernel
    {
        private static const MOST_STEPS:int = 80;

        private var _finder:GapFinder;
        private var _convex:ConvexPairKernel;

        private var _gap:RoundGap = new RoundGap();

        /**
         * @param finder finds the gap of the kernel's pairs
         * @param convex finds their contact if the cores overlap, and their time of impact if they have hardly any radius
         */
        public function RoundKernel(finder:GapFinder, convex:ConvexPairKernel)
        {
            _finder = finder;
            _convex = convex;
        }

        /**
         * Finds when the gap is as long as the sum of the radii. Newton's method never steps over the first zero when it starts to the left of it. Each
         * step shrinks the product of the gap and its slope to a quarter, and both are numbers of 53 bits. So 80 steps are enough. Should rounding need
         * more, the time of the last step is the time of impact: the structures do not touch before, and their gap is at most rounding.
         *
         * @inheritDoc
         */
        override public function findTime(a:BoundingStructure, b:BoundingStructure, motion:RelativeMotion):void
        {
            var gap:RoundGap = _gap;
            motion.time = 0;
            _finder.find(a, b, motion, gap);
            var radii:Number = gap.cores.radiusA + gap.cores.radiusB;
            var margins:Number = motion.margin;
            var touchingDistance:Number = radii * Tolerances.TOUCHING + margins;
            if (gap.squaredLength <= touchingDistance * touchingDistance)
            {
                return;
            }
            if (radii < Tolerances.DIRECTION * gap.extent)
            {
                _convex.findTime(a, b, motion);
                return;
            }
            // at this length no gap is left, or one as short as rounding, which has no direction for another step
            var closed:Number = radii > margins ? radii : margins;
            var isTouching:Boolean = false;
            for (var step:int = 1; step < MOST_STEPS; step++)
            {
                // when the plane between the closest points, moved along, has no gap left
                var distance:Number = Math.sqrt(gap.squaredLength);
                var next:Number = gap.closing > 0 ? motion.time + (distance - radii) * distance / gap.closing : RelativeMotion.NEVER;
                if (isTouching)
                {
                    motion.time = next <= motion.latest ? next : motion.time;
                    return;
                }
                if (!(next > motion.time))
                {
                    // the rest of the gap is so short that rounding leaves no step, so they touch now
                    return;
                }
                motion.time = next <= motion.latest ? next : RelativeMotion.NEVER;
                if (motion.time == RelativeMotion.NEVER)
                {
                    return;
                }
                _finder.find(a, b, motion, gap);
                if (gap.squaredLength <= closed * closed)
                {
                    return;
                }
                // If they touch to within rounding only, one more step makes up for a step that rounding may have skipped.
                isTouching = gap.squaredLength <= touchingDistance * touchingDistance;
            }
        }

        /** @inheritDoc */
        override public function findContact(a:BoundingStructure, b:BoundingStructure, motion:RelativeMotion, out:ContactPoint):void
        {
            var gap:RoundGap = _gap;
            _finder.find(a, b, motion, gap);
            // If the gap is longer than this, it has a direction in spite of rounding.
            var least:Number = Tolerances.DIRECTION * gap.extent;
            if (gap.squaredLength > least * least)
            {
                out.setFromGap(gap.cores, motion);
            }
            else
            {
                _convex.findOverlap(a, b, motion, out);
            }
        }

        /** @inheritDoc */
        override public function findClosest(a:BoundingStructure, b:BoundingStructure, out:ClosestPoints):void
        {
            // Two of one kind are capsules. They have one order for (a, b) and (b, a), so that rounding is the same. Capsules with the same start touch, so
            // their order does not matter.
            var areSwapped:Boolean = a.kind == b.kind && isAfter((a as Capsule).start, (b as Capsule).start);
            _finder.find(areSwapped ? b : a, areSwapped ? a : b, RelativeMotion.NONE, _gap);
            out.setFromGap(_gap.cores);
            if (areSwapped)
            {
                out.swap();
            }
        }
    }
}
