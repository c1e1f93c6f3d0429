package starlogo.convex
{
    import starlogo.geometry.Tolerances;

    /**
     * Finds when a moving shape first touches another one, by conservative advancement. The distance is a convex function of the time. So Newton's
     * method from the left never steps over its first zero (van den Bergen, "Ray casting against general convex objects with application to
     * continuous collision detection", 2004). A step ends when no gap is left along the line between the closest points. Should rounding need more
     * than 80 steps, the time is that of the last step: the shapes do not touch before, and their gap is at most rounding.
     */
    internal final class ConvexSweep
    {
        private static const MOST_STEPS:int = 80;

        private var _distance:CoreDistance = new CoreDistance();
        private var _overlap:CoreOverlap = new CoreOverlap();
        private var _witness:CoreWitness = new CoreWitness();
        private var _exact:CoreWitness = new CoreWitness();
        private var _balls:CoreGap = new CoreGap();

        /**
         * Finds the time.
         *
         * @param cores has the shapes where they are stored; overwritten
         * @param motion the motion of a: see ConvexKernel
         */
        public function findTime(cores:CorePair, motion:RelativeMotion):void
        {
            begin(cores, motion);
            // The last time at which the shapes touch, but only across the gap for rounding. Then one more step leads to where they touch without it,
            // and counts if they still touch there.
            var lastTouch:Number = RelativeMotion.NEVER;
            for (var step:int = 0; step < MOST_STEPS && motion.time <= motion.latest; step++)
            {
                measure(cores, motion, step > 0);
                if (isTouch(cores))
                {
                    if (lastTouch != RelativeMotion.NEVER || motion.time == 0 || _witness.distance <= cores.first.radius + cores.second.radius)
                    {
                        return;
                    }
                    lastTouch = motion.time;
                }
                else if (lastTouch != RelativeMotion.NEVER)
                {
                    break;
                }
                else
                {
                    refine(cores);
                }
                advance(cores, motion);
            }
            // The step after a touch has led out of it, or there is none in time. If all steps are used up, the time is that of the last one.
            if (lastTouch != RelativeMotion.NEVER || !(motion.time <= motion.latest))
            {
                motion.time = lastTouch;
            }
        }

        // Begins at the motion's earliest time, or when balls around the two first meet if that is later.
        private function begin(cores:CorePair, motion:RelativeMotion):void
        {
            motion.time = 0;
            cores.setMotion(motion);
            cores.maxDistance += motion.margin;
            var balls:CoreGap = _balls;
            // the motion is that of a
            var side:int = cores.isSwapped ? -1 : 1;
            balls.x = side * cores.x;
            balls.y = side * cores.y;
            balls.z = side * cores.z;
            balls.radiusA = Tolerances.OUTER * (cores.maxDistance + cores.first.extent + cores.second.extent);
            balls.radiusB = 0;
            findTimeOfSpheres(balls, motion);
            motion.time = motion.earliest > motion.time ? motion.earliest : motion.time;
        }

        // Finds the distance at the motion's time.
        private function measure(cores:CorePair, motion:RelativeMotion, isAgain:Boolean):void
        {
            cores.moveTo(motion);
            if (isAgain)
            {
                _distance.findAgain(cores, _witness);
            }
            else
            {
                _distance.find(cores, _witness);
            }
        }

        // Whether the shapes touch. areTouching() stops at the first direction along which the gap is too wide. The distance may be less than that gap
        // by rounding, so the gap counts here too.
        private function isTouch(cores:CorePair):Boolean
        {
            return _witness.distance <= cores.maxDistance && !(_witness.separation > cores.maxDistance);
        }

        // Replaces the direction that keeps the cores apart, if no gap is left along it. A short line between two points is too imprecise where an edge
        // or a face is nearly perpendicular to it. The normals of faces and pairs of edges are precise.
        private function refine(cores:CorePair):void
        {
            var witness:CoreWitness = _witness;
            if (witness.separation > cores.first.radius + cores.second.radius)
            {
                return;
            }
            _overlap.find(cores, _exact);
            if (_exact.separation > witness.separation)
            {
                witness.setAxis(_exact.normalX, _exact.normalY, _exact.normalZ, _exact.separation);
            }
        }

        // Moves the motion's time on to when no gap is left along the direction that keeps the cores apart; to NEVER if that is not later.
        private function advance(cores:CorePair, motion:RelativeMotion):void
        {
            var witness:CoreWitness = _witness;
            var speed:Number = -(witness.normalX * cores.motionX + witness.normalY * cores.motionY + witness.normalZ * cores.motionZ);
            var next:Number = motion.time + (witness.separation - (cores.first.radius + cores.second.radius)) / speed;
            motion.time = speed > 0 && next > motion.time ? next : RelativeMotion.NEVER;
        }
    }
}
