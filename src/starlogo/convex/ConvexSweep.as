package starlogo.convex
{
    import starlogo.geometry.Tolerances;

    /**
     * Finds when a moving shape first touches another one. The distance is a convex function of the time. So Newton's method from the left never
     * steps over its first zero (van den Bergen, "Ray casting against general convex objects with application to continuous collision
     * detection", 2004). A step ends when no gap is left along the line between the closest points. Should rounding need more than 80 steps,
     * the time is that of the last step: the shapes do not touch before, and their gap is at most rounding.
     */
    internal final class ConvexSweep
    {
        private static const MOST_STEPS:int = 80;

        private var _distance:CoreDistance = new CoreDistance();
        private var _overlap:CoreOverlap = new CoreOverlap();
        private var _witness:CoreWitness = new CoreWitness();
        private var _exact:CoreWitness = new CoreWitness();
        private var _balls:CoreGap = new CoreGap();

        // The latest time at which the shapes touch within rounding.
        private var _lastTouch:Number = 0;

        /**
         * Finds the time.
         *
         * @param cores has the shapes where they are stored; overwritten
         * @param motion the motion of a: see ConvexKernel
         */
        public function findTime(cores:CorePair, motion:RelativeMotion):void
        {
            motion.time = 0;
            cores.setMotion(motion);
            include "motionMargin.inc";
            cores.touchingDistance += margin;
            _lastTouch = RelativeMotion.NEVER;
            skipToBalls(cores, motion);
            motion.time = motion.earliest > motion.time ? motion.earliest : motion.time;
            for (var step:int = 0; step < MOST_STEPS && motion.time <= motion.latest; step++)
            {
                cores.moveTo(motion);
                cores.timeLeft = motion.latest - motion.time;
                if (step == 0)
                {
                    _distance.find(cores, _witness);
                }
                else
                {
                    _distance.findAgain(cores, _witness);
                }
                if (!advance(cores, motion))
                {
                    return;
                }
            }
            if (!(motion.time <= motion.latest))
            {
                motion.time = _lastTouch;
            }
        }

        // Moves the motion's time on, from 0 to when balls around the two first meet.
        private function skipToBalls(cores:CorePair, motion:RelativeMotion):void
        {
            var balls:CoreGap = _balls;
            // the motion is that of a
            var side:int = cores.isSwapped ? -1 : 1;
            balls.x = side * cores.x;
            balls.y = side * cores.y;
            balls.z = side * cores.z;
            balls.radiusA = Tolerances.OUTER * (cores.touchingDistance + cores.first.extent + cores.second.extent);
            balls.radiusB = 0;
            findSphereEntry(balls, motion);
        }

        // Sets the motion's time to that of the next step. If the search ends, sets it to the time of the first touch and returns false.
        private function advance(cores:CorePair, motion:RelativeMotion):Boolean
        {
            var witness:CoreWitness = _witness;
            var radii:Number = cores.first.radius + cores.second.radius;
            // areTouching() stops at the first direction along which the gap is too wide. The distance may be less than that gap by rounding, so the
            // gap counts here too.
            var areTouching:Boolean = witness.distance <= cores.touchingDistance && !(witness.separation > cores.touchingDistance);
            if (_lastTouch <= 1)
            {
                // the last step counts only if they still touch after it
                motion.time = areTouching ? motion.time : _lastTouch;
                return false;
            }
            if (areTouching && (motion.time == 0 || witness.distance <= radii))
            {
                return false;
            }
            if (areTouching)
            {
                // one more step, to where they touch without the gap for rounding
                _lastTouch = motion.time;
            }
            if (!areTouching && witness.separation <= radii)
            {
                refine(cores);
            }
            var speed:Number = -(witness.normalX * cores.motionX + witness.normalY * cores.motionY + witness.normalZ * cores.motionZ);
            var next:Number = speed > 0 ? motion.time + (witness.separation - radii) / speed : RelativeMotion.NEVER;
            if (!(next > motion.time))
            {
                // rounding leaves no step
                motion.time = _lastTouch;
                return false;
            }
            motion.time = next;
            return true;
        }

        // Replaces the direction that keeps the cores apart. A short line between two points is too imprecise where an edge or a face is nearly
        // perpendicular to it. The normals of faces and pairs of edges are precise.
        private function refine(cores:CorePair):void
        {
            var witness:CoreWitness = _witness;
            _overlap.find(cores, _exact);
            if (_exact.separation > witness.separation)
            {
                witness.separation = _exact.separation;
                witness.normalX = _exact.normalX;
                witness.normalY = _exact.normalY;
                witness.normalZ = _exact.normalZ;
            }
        }
    }
}
