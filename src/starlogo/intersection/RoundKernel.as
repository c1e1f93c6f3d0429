package starlogo.intersection
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.convex.ClosestPoints;
    import starlogo.convex.ContactPoint;
    import starlogo.convex.CoreGap;
    import starlogo.convex.RelativeMotion;
    import starlogo.geometry.Tolerances;

    /**
     * The kernel of two structures of which at least one is a sphere or a capsule, except for two spheres. It answers by the gap between their cores
     * and the radii. A GapFinder for each pair of kinds finds the gap. If the cores overlap, there is no gap, and the ConvexPairKernel finds the
     * contact.
     *
     * <p>Two cores have a distance that is a convex function of time if one moves along a straight line. So Newton's method finds the time of
     * impact (van den Bergen, "Ray casting against general convex objects with application to continuous collision detection", 2004). ConvexSweep
     * takes such steps for all other shapes. It finds the gap of each step by a search, and gets the direction of a short gap from faces and
     * edges. Here a formula gives the gap, and chords take the place of a direction that is not certain.</p>
     *
     * @private
     */
    public final class RoundKernel extends PairKernel
    {
        private static const MOST_STEPS:int = 80;

        private var _finder:GapFinder;
        private var _convex:ConvexPairKernel;

        // The gap at the motion's time.
        private var _gap:CoreGap = new CoreGap();

        /**
         * @param finder finds the gap of the kernel's pairs
         * @param convex finds their contact if the cores overlap
         */
        public function RoundKernel(finder:GapFinder, convex:ConvexPairKernel)
        {
            _finder = finder;
            _convex = convex;
        }

        /** @inheritDoc */
        override public function findTime(a:BoundingStructure, b:BoundingStructure, motion:RelativeMotion):void
        {
            var gap:CoreGap = _gap;
            motion.time = 0;
            _finder.find(a, b, motion, gap);
            var radii:Number = gap.radiusA + gap.radiusB;
            var touchingDistance:Number = radii * Tolerances.TOUCHING + motion.margin;
            var squared:Number = gap.squaredLength;
            if (squared <= touchingDistance * touchingDistance)
            {
                return;
            }
            var closing:Number = gap.closing;
            if (closing > 0)
            {
                // most pairs need only this step of Newton's method
                var distance:Number = Math.sqrt(squared);
                motion.time = (distance - radii) * distance / closing;
                if (motion.time <= motion.latest && findZero(a, b, motion))
                {
                    return;
                }
            }
            motion.time = RelativeMotion.NEVER;
        }

        /** @inheritDoc */
        override public function findContact(a:BoundingStructure, b:BoundingStructure, motion:RelativeMotion, out:ContactPoint):void
        {
            var gap:CoreGap = _gap;
            _finder.find(a, b, motion, gap);
            // If the gap is longer than this, it has a direction in spite of rounding.
            var least:Number = Tolerances.DIRECTION * gap.extent;
            if (gap.squaredLength > least * least)
            {
                out.setFromGap(gap);
            }
            else
            {
                _convex.findOverlap(a, b, motion, out);
            }
        }

        /** @inheritDoc */
        override public function findClosest(a:BoundingStructure, b:BoundingStructure, out:ClosestPoints):void
        {
            var areSwapped:Boolean = _finder.areSwapped(a, b);
            _finder.find(areSwapped ? b : a, areSwapped ? a : b, RelativeMotion.NONE, _gap);
            out.setFromGap(_gap);
            if (areSwapped)
            {
                out.swap();
            }
        }

        // Finds when the gap is as long as the sum of the radii, by Newton's method, which never steps over the first zero when it starts to the left of
        // it. When it begins, the gap is that of time 0, and the motion's time is that of the first step. When it ends, the motion's time is the time of
        // impact. Returns false if that is after the motion's latest time.
        // Each step shrinks the product of the gap and its slope to a quarter, and both are numbers of 53 bits. So 80 steps are enough. Should rounding
        // need more, the time of the last step is the time of impact: the structures do not touch before, and their gap is at most rounding.
        private function findZero(a:BoundingStructure, b:BoundingStructure, motion:RelativeMotion):Boolean
        {
            var gap:CoreGap = _gap;
            var radii:Number = gap.radiusA + gap.radiusB;
            // A gap that is no longer than this has no certain direction.
            var uncertain:Number = Tolerances.DIRECTION * gap.extent;
            // Radii allow for the rounding of the gap at each step. Where there are hardly any, the extent does.
            var rounding:Number = radii < uncertain ? Tolerances.ROUNDING * gap.extent : 0;
            var touchingDistance:Number = radii * Tolerances.TOUCHING + motion.margin + rounding;
            // At this length no gap is left, or one as short as the margins, which has no direction for another step.
            var closed:Number = Math.max(radii, touchingDistance - radii);
            var lastTime:Number = 0;
            var lastDistance:Number = Math.sqrt(gap.squaredLength);
            var hasOvershot:Boolean = false;
            for (var step:int = 1; step < MOST_STEPS; step++)
            {
                _finder.find(a, b, motion, gap);
                var time:Number = motion.time;
                var squared:Number = gap.squaredLength;
                if (4 * squared < radii * radii)
                {
                    // the slope had so large a rounding error that the step went beyond the zero, so half of it is taken
                    motion.time = (lastTime + time) / 2;
                    hasOvershot = true;
                    continue;
                }
                if (squared <= closed * closed)
                {
                    return true;
                }
                var distance:Number = Math.sqrt(squared);
                var closing:Number = gap.closing;
                var next:Number = RelativeMotion.NEVER;
                if ((hasOvershot || distance < uncertain) && distance < lastDistance)
                {
                    // rounding hides the slope, so the chord through this distance and the last one takes its place. It does not step over the zero either
                    next = time + (distance - radii) * (time - lastTime) / (lastDistance - distance);
                }
                else if (closing > 0)
                {
                    // when the plane between the closest points, moved along, has no gap left
                    next = time + (distance - radii) * distance / closing;
                }
                if (squared <= touchingDistance * touchingDistance)
                {
                    // They touch to within rounding. One more step makes up for a step that rounding may have skipped.
                    motion.time = next <= motion.latest ? next : time;
                    return true;
                }
                if (!(next > time))
                {
                    // The rest of the gap is so short that rounding leaves no step. They touch at this time.
                    return true;
                }
                if (!(next <= motion.latest))
                {
                    return false;
                }
                lastTime = time;
                lastDistance = distance;
                motion.time = next;
            }
            return true;
        }
    }
}
