package starlogo.convex
{
    import starlogo.geometry.Tolerances;

    /** Finds when a moving shape first touches another one, step by step: see AdvancementStep. */
    internal final class ConvexSweep
    {
        private var _distance:CoreDistance;
        private var _overlap:CoreOverlap;
        private var _step:AdvancementStep = new AdvancementStep();
        private var _witness:CoreWitness = new CoreWitness();
        private var _balls:CoreGap = new CoreGap();

        /**
         * @param distance finds the gap of each step
         * @param overlap finds a more precise direction where the gap is too short for one
         */
        public function ConvexSweep(distance:CoreDistance, overlap:CoreOverlap)
        {
            _distance = distance;
            _overlap = overlap;
        }

        /**
         * Finds the time.
         *
         * @param cores has the shapes where they are stored; overwritten
         * @param motion the motion of a: see ConvexKernel
         */
        public function findTime(cores:CorePair, motion:RelativeMotion):void
        {
            begin(cores, motion);
            if (!(motion.time <= motion.latest))
            {
                motion.time = RelativeMotion.NEVER;
                return;
            }
            cores.moveTo(motion);
            _distance.find(cores, _witness);
            while (measure(cores).advance(motion))
            {
                cores.moveTo(motion);
                _distance.findAfterMove(cores, _witness);
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
            motion.time = motion.earliest > motion.time ? motion.earliest : motion.time;
        }

        // Returns the step, from the distance at the motion's time. Where the cores are hardly apart along any axis, the step may be as long as the gap in
        // the motion's direction, because no shape comes nearer faster than that. Of the two the longer step counts: neither leads past a touch.
        private function measure(cores:CorePair):AdvancementStep
        {
            var witness:CoreWitness = _witness;
            var step:AdvancementStep = _step;
            step.isTouching = witness.isWithinLimit(cores);
            var isProven:Boolean = step.isTouching || witness.separation > cores.searchLimit;
            if (!isProven)
            {
                // A short line between two points is too imprecise a direction where an edge or a face is nearly perpendicular to it. The normals of
                // faces and pairs of edges are precise.
                _overlap.tryNormals(cores, witness);
            }
            var x:Number = cores.motionX;
            var y:Number = cores.motionY;
            var z:Number = cores.motionZ;
            var radii:Number = cores.first.radius + cores.second.radius;
            step.separation = witness.separation - radii;
            step.speed = -(witness.normalX * x + witness.normalY * y + witness.normalZ * z);
            if (!isProven)
            {
                var fullSpeed:Number = Math.sqrt(x * x + y * y + z * z);
                var distance:Number = witness.distance - radii;
                if (!(step.separation > 0 && step.separation * fullSpeed >= distance * step.speed))
                {
                    step.separation = distance;
                    step.speed = fullSpeed;
                }
            }
            return step;
        }
    }
}
