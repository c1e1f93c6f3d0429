package starlogo.intersection.sweep
{
    import starlogo.convex.RelativeMotion;
    import starlogo.geometry.Tolerances;
    import starlogo.intersection.distance.RoundGap;

    /**
     * Applies Newton's method to the distance of two cores, one of which moves: finds when they are as far apart as the sum of the radii.
     * The caller measures the gap at the time in <code>way.time</code>, and takes the next step as long as a method returns true.
     *
     * <p>The distance is a convex function of time, so the method never steps over the first zero when it starts to the left of it. Each step
     * shrinks the product of the gap and its slope to a quarter, and both are numbers of 53 bits. So 80 steps are enough. Should rounding need
     * more, the time of the last step is the time of impact: the structures do not touch before, and their gap is at most rounding.</p>
     *
     * <p>If the cores are very close, rounding hides the direction of the gap, and with it the slope. Then a chord takes the place of the
     * tangent: it goes through this distance and that of the step before, and does not step over the first zero either. A step that went too
     * far because of rounding is halved.</p>
     *
     * @private
     */
    public final class NewtonSteps
    {
        private static const MOST_STEPS:int = 80;

        private var _count:int = 0;
        private var _hasOvershot:Boolean = false;

        // The step before.
        private var _lastTime:Number = 0;
        private var _lastDistance:Number = 0;

        /**
         * Takes the first step, from time 0. Most pairs need no other.
         *
         * @param motion the motion of the first structure; receives its rounding
         * @param way the same motion in the axes of the gap; receives the time
         * @param gap the gap at time 0, and the radii
         * @return whether the gap at the new time has to be measured. If not, the time is the time of impact, or RelativeMotion.NEVER
         */
        public function begin(motion:RelativeMotion, way:RelativeMotion, gap:RoundGap):Boolean
        {
            motion.findRounding();
            way.rounding = motion.rounding;
            way.latest = motion.latest;
            way.time = 0;
            var x:Number = gap.x;
            var y:Number = gap.y;
            var z:Number = gap.z;
            var radiusSum:Number = gap.radiusA + gap.radiusB;
            var reach:Number = radiusSum * Tolerances.TOUCHING + way.rounding;
            var squared:Number = x * x + y * y + z * z;
            if (squared <= reach * reach)
            {
                return false;
            }
            way.time = RelativeMotion.NEVER;
            var closing:Number = -(x * way.x + y * way.y + z * way.z);
            if (!(closing > 0))
            {
                return false;
            }
            var distance:Number = Math.sqrt(squared);
            var time:Number = (distance - radiusSum) * distance / closing;
            if (!(time <= way.latest))
            {
                return false;
            }
            way.time = time;
            _count = 1;
            _hasOvershot = false;
            _lastTime = 0;
            _lastDistance = distance;
            return true;
        }

        /**
         * Takes the next step.
         *
         * @param way the motion in the axes of the gap; receives the time
         * @param gap the gap at the time of the step before, the radii and the size
         * @return see begin
         */
        public function next(way:RelativeMotion, gap:RoundGap):Boolean
        {
            var x:Number = gap.x;
            var y:Number = gap.y;
            var z:Number = gap.z;
            var time:Number = way.time;
            var radiusSum:Number = gap.radiusA + gap.radiusB;
            var squared:Number = x * x + y * y + z * z;
            _count++;
            if (4 * squared < radiusSum * radiusSum)
            {
                // The slope had so large a rounding error that the step went beyond the zero.
                way.time = _count < MOST_STEPS ? (_lastTime + time) / 2 : _lastTime;
                _hasOvershot = true;
                return _count < MOST_STEPS;
            }
            // A gap that is no longer than this has no certain direction.
            var uncertain:Number = Tolerances.DIRECTION * gap.size;
            var reach:Number = radiusSum * Tolerances.TOUCHING + way.rounding;
            if (radiusSum < uncertain)
            {
                reach += Tolerances.ROUNDING * gap.size;
            }
            var isTouching:Boolean = squared <= reach * reach;
            if (isTouching && (squared <= radiusSum * radiusSum || squared <= (reach - radiusSum) * (reach - radiusSum)))
            {
                return false;
            }
            var distance:Number = Math.sqrt(squared);
            var nextTime:Number = RelativeMotion.NEVER;
            var closing:Number = -(x * way.x + y * way.y + z * way.z);
            if ((_hasOvershot || distance < uncertain) && distance < _lastDistance)
            {
                nextTime = time + (distance - radiusSum) * (time - _lastTime) / (_lastDistance - distance);
            }
            else if (closing > 0)
            {
                // The time at which the plane between the closest points, moved along, has no gap left.
                nextTime = time + (distance - radiusSum) * distance / closing;
            }
            if (isTouching)
            {
                // They touch to within rounding. One more step makes up for a step that rounding may have skipped.
                way.time = nextTime <= 1 ? nextTime : time;
                return false;
            }
            if (!(nextTime > time))
            {
                // The rest of the gap is so short that rounding leaves no step. They touch at this time.
                return false;
            }
            _lastTime = time;
            _lastDistance = distance;
            var isInTime:Boolean = nextTime <= way.latest;
            way.time = isInTime ? nextTime : RelativeMotion.NEVER;
            return isInTime && _count < MOST_STEPS;
        }
    }
}
