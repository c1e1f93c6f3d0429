// The package convex decides about two convex shapes. A shape is a core of points with a radius (ConvexShape). A ConvexKernel answers: GjkDistance
// finds the distance of two cores with the help of Simplex, ConservativeAdvancement steps to the time of impact, SatPenetration finds the shortest
// displacement out of an overlap, ContactPointFinder the point of a contact. Read ConvexShape first, then ConvexKernel from the top, then CorePair,
// GjkDistance, Simplex and SimplexPart.
// 
// In all packages a kernel decides about two shapes or structures, and a pair is two of them. The records of questions and answers (RelativeMotion,
// ClosestPoints, ContactPoint) stand here for all packages, because the others that fill them may use this one.

package starlogo.convex
{
    import starlogo.geometry.Tolerances;

    /**
     * Answers four questions about any two convex shapes: whether they touch, where they are closest, when a moving one first touches the other,
     * and how far they overlap. a and b are the two of a question, in the order of the call; a is the one that moves.
     *
     * <p>areTouching and findTimeOfImpact agree about what touches (see Touching), except that findTimeOfImpact may miss a touch across the margins
     * alone: see ConservativeAdvancement. findTimeOfImpact adds the margin of the motion. The distance and the depth leave all margins out, so shapes
     * that touch may have a distance as small as the margins, and the depth 0. CorePair says how far the order of the two matters. Memory
     * is allocated only for lists that grow with the largest hull so far.</p>
     *
     * @private
     */
    public final class ConvexKernel
    {
        private var _gjk:GjkDistance = new GjkDistance();
        private var _sat:SatPenetration = new SatPenetration();
        private var _pointFinder:ContactPointFinder = new ContactPointFinder();
        private var _step:ConservativeAdvancement = new ConservativeAdvancement();
        private var _cores:CorePair = new CorePair();
        private var _result:GjkResult = new GjkResult();

        // The gap of two balls, one around each shape of a sweep.
        private var _balls:BallGap = new BallGap();

        /** Whether two shapes touch or overlap. */
        public function areTouching(a:ConvexShape, b:ConvexShape):Boolean
        {
            _cores.setShapes(a, b);
            _cores.limitToTouching();
            _gjk.find(_cores, _result);
            return _result.isWithinLimit(_cores);
        }

        /** Finds the distance and the closest points of two shapes. */
        public function findClosest(a:ConvexShape, b:ConvexShape, out:ClosestPoints):void
        {
            out.distance = Infinity;
            findCloser(a, b, out);
        }

        /**
         * Finds the distance and the closest points of two shapes if they are closer than a pair before.
         *
         * @param out the distance and the points of the pair before; overwritten if this one is closer
         * @return whether it is closer
         */
        public function findCloser(a:ConvexShape, b:ConvexShape, out:ClosestPoints):Boolean
        {
            _cores.setShapes(a, b);
            _cores.searchLimit = out.distance + (a.radius + b.radius);
            _gjk.find(_cores, _result);
            var distance:Number = _result.distance - (a.radius + b.radius);
            distance = distance > 0 ? distance : 0;
            if (!(distance < out.distance))
            {
                return false;
            }
            // the points of the shapes need the radii too
            var gap:CoreGap = _result.gap;
            gap.radiusA = _cores.first.radius;
            gap.radiusB = _cores.second.radius;
            out.setFromGap(gap);
            if (_cores.isSwapped)
            {
                out.swap();
            }
            return true;
        }

        /**
         * Finds when a moving shape first touches another one, step by step: see ConservativeAdvancement.
         *
         * @param motion the motion of a; receives the time
         */
        public function findTimeOfImpact(a:ConvexShape, b:ConvexShape, motion:RelativeMotion):void
        {
            var cores:CorePair = _cores;
            beginSweep(a, b, motion);
            if (!(motion.time <= motion.latestTime))
            {
                motion.time = RelativeMotion.NEVER;
                return;
            }
            cores.moveTo(motion);
            _gjk.find(cores, _result);
            while (measureStep().advance(motion))
            {
                cores.moveTo(motion);
                _gjk.findAfterMove(cores, _result);
            }
        }

        // Begins at the motion's earliest time, or when balls around the two first meet if that is later.
        private function beginSweep(a:ConvexShape, b:ConvexShape, motion:RelativeMotion):void
        {
            var cores:CorePair = _cores;
            _step.reset();
            motion.time = 0;
            cores.setShapes(a, b);
            cores.setMotion(motion);
            cores.limitToTouching();
            cores.searchLimit += motion.margin;
            _balls.x = a.origin.x - b.origin.x + motion.startX;
            _balls.y = a.origin.y - b.origin.y + motion.startY;
            _balls.z = a.origin.z - b.origin.z + motion.startZ;
            _balls.touchDistance = Tolerances.OUTER * (cores.searchLimit + cores.first.boundingRadius + cores.second.boundingRadius);
            findTimeOfImpactOfSpheres(_balls, motion);
            motion.time = motion.earliestTime > motion.time ? motion.earliestTime : motion.time;
        }

        // Returns the step from what was found at the motion's time. Two steps are possible, neither of which leads past a touch, and the longer one counts.
        // One closes the separation along the axis. The other closes the distance at the motion's full speed, because no shape comes nearer faster than
        // that. It is needed only where no axis proves much of a gap.
        private function measureStep():ConservativeAdvancement
        {
            var cores:CorePair = _cores;
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

        /**
         * Finds the contact of two shapes that touch or overlap: the shortest displacement of a that separates them, and the middle of what they have
         * in common. If several displacements are equally short, SatPenetration says which it is.
         *
         * @param motion the motion of a; a is where it is at the motion's time
         * @param out receives the contact
         */
        public function findContact(a:ConvexShape, b:ConvexShape, motion:RelativeMotion, out:ContactPoint):void
        {
            beginContact(a, b, motion);
            _gjk.find(_cores, _result);
            var distance:Number = _result.distance;
            if (distance > Tolerances.PERPENDICULAR_GAP * (a.boundingRadius + b.boundingRadius))
            {
                _result.axis.setTo(_result.gap.x / distance, _result.gap.y / distance, _result.gap.z / distance, distance);
            }
            else
            {
                _sat.findMinimumTranslation(_cores, _result.axis);
                if (distance > 0)
                {
                    _sat.considerGap(_result.gap, _cores, _result.axis);
                }
            }
            finishContact(motion, out);
        }

        /** Finds the contact of two shapes whose cores touch or overlap, as findContact() does. It is faster, because it does not find the distance. */
        public function findOverlap(a:ConvexShape, b:ConvexShape, motion:RelativeMotion, out:ContactPoint):void
        {
            beginContact(a, b, motion);
            _sat.findMinimumTranslation(_cores, _result.axis);
            finishContact(motion, out);
        }

        // Moves the first core to where it is at the motion's time.
        private function beginContact(a:ConvexShape, b:ConvexShape, motion:RelativeMotion):void
        {
            _cores.setShapes(a, b);
            if (motion.time > 0)
            {
                _cores.setMotion(motion);
            }
            else
            {
                // a has not come from anywhere
                _cores.moveTo(motion);
            }
        }

        // Makes the contact of the axis of the cores, by their radii.
        private function finishContact(motion:RelativeMotion, out:ContactPoint):void
        {
            out.forget();
            out.setNormal(_result.axis.x, _result.axis.y, _result.axis.z);
            var depth:Number = _cores.first.radius + _cores.second.radius - _result.axis.separation;
            out.depth = depth > 0 ? depth : 0;
            _pointFinder.find(_cores, out);
            out.x += _cores.second.origin.x;
            out.y += _cores.second.origin.y;
            out.z += _cores.second.origin.z;
            if (_cores.isSwapped)
            {
                out.swap(motion);
            }
        }
    }
}
