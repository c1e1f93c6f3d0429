package starlogo.convex
{
    import starlogo.geometry.Tolerances;

    /** Finds when a moving shape first touches another one, step by step: see ConservativeAdvancement. */
    internal final class ConvexSweep
    {
        private var _gjk:GjkDistance;
        private var _sat:SatPenetration;
        private var _step:ConservativeAdvancement = new ConservativeAdvancement();
        private var _result:GjkResult = new GjkResult();
        private var _balls:CoreGap = new CoreGap();

        /**
         * @param gjk finds the gap of each step
         * @param sat finds a more precise direction where the gap is too short for one
         */
        public function ConvexSweep(gjk:GjkDistance, sat:SatPenetration)
        {
            _gjk = gjk;
            _sat = sat;
        }

        /**
         * Finds the time.
         *
         * @param cores has the shapes where they are stored; overwritten
         * @param motion the motion of a: see ConvexKernel
         */
        public function findTimeOfImpact(cores:CorePair, motion:RelativeMotion):void
        {
            begin(cores, motion);
            if (!(motion.time <= motion.latestTime))
            {
                motion.time = RelativeMotion.NEVER;
                return;
            }
            cores.moveTo(motion);
            _gjk.find(cores, _result);
            while (measure(cores).advance(motion))
            {
                cores.moveTo(motion);
                _gjk.findAfterMove(cores, _result);
            }
        }

        // Begins at the motion's earliest time, or when balls around the two first meet if that is later.
        private function begin(cores:CorePair, motion:RelativeMotion):void
        {
            _step.reset();
            motion.time = 0;
            cores.setMotion(motion);
            cores.limitToTouching();
            cores.searchLimit += motion.margin;
            var balls:CoreGap = _balls;
            // the motion is that of a
            var side:int = cores.isSwapped ? -1 : 1;
            balls.x = side * cores.x;
            balls.y = side * cores.y;
            balls.z = side * cores.z;
            balls.radiusA = Tolerances.OUTER * (cores.searchLimit + cores.first.extent + cores.second.extent);
            balls.radiusB = 0;
            findTimeOfSpheres(balls, motion);
            motion.time = motion.earliestTime > motion.time ? motion.earliestTime : motion.time;
        }

        // Returns the step from what was found at the motion's time. Two steps are possible, neither of which leads past a touch, and the longer one counts.
        // One closes the separation along the axis. The other closes the distance at the motion's full speed, because no shape comes nearer faster than
        // that. It is needed only where no axis proves much of a gap.
        private function measure(cores:CorePair):ConservativeAdvancement
        {
            var axis:SeparatingAxis = _result.axis;
            var step:ConservativeAdvancement = _step;
            step.isTouching = _result.isWithinLimit(cores);
            var isProven:Boolean = step.isTouching || axis.separation > cores.searchLimit;
            if (!isProven)
            {
                // A short line between two points is too imprecise a direction where an edge or a face is nearly perpendicular to it. The normals of
                // faces and pairs of edges are precise.
                _sat.considerNormals(cores, axis);
            }
            var x:Number = cores.motionX;
            var y:Number = cores.motionY;
            var z:Number = cores.motionZ;
            var radii:Number = cores.first.radius + cores.second.radius;
            step.separation = axis.separation - radii;
            step.speed = -(axis.x * x + axis.y * y + axis.z * z);
            if (!isProven)
            {
                var fullSpeed:Number = Math.sqrt(x * x + y * y + z * z);
                var distance:Number = _result.distance - radii;
                var isAxisLonger:Boolean = step.separation > 0 && step.separation * fullSpeed >= distance * step.speed;
                step.separation = isAxisLonger ? step.separation : distance;
                step.speed = isAxisLonger ? step.speed : fullSpeed;
            }
            return step;
        }
    }
}
