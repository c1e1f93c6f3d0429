package starlogo.convex
{
    import flash.geom.Vector3D;
    import starlogo.geometry.Tolerances;

    /**
     * Answers four questions about any two convex shapes: whether they touch, where they are closest, when a moving one first touches the other,
     * and how far they overlap. A shape is a core of points with a radius (ConvexShape); CoreDistance finds the distance of two cores with the help
     * of Simplex, CoreOverlap the way out of an overlap, CommonPoint the point of a contact. Read ConvexShape first, then this class from the top,
     * then CoreDistance.
     *
     * <p>areTouching and findTime agree about what touches: see Touching. findTime adds the margin of the motion. The distance and the depth leave
     * all margins out, so shapes that touch may have a distance as small as the margins, and the depth 0. The same two shapes in the other order
     * get the same answer, to the last bit. Memory is allocated only for the
     * first hulls, whose lists are kept.</p>
     *
     * @private
     */
    public final class ConvexPair
    {
        private static const MOST_STEPS:int = 80;

        private var _distance:CoreDistance = new CoreDistance();
        private var _overlap:CoreOverlap = new CoreOverlap();
        private var _common:CommonPoint = new CommonPoint();
        private var _cores:CorePair = new CorePair();
        private var _witness:CoreWitness = new CoreWitness();
        private var _gap:CoreGap = new CoreGap();
        private var _exact:ContactPoint = new ContactPoint();

        // Where the motion begins: the vector from b's origin to a's. The latest time at which the shapes touch within rounding.
        private var _from:Vector3D = new Vector3D();
        private var _lastTouch:Number = 0;

        /** Whether two shapes touch or overlap. */
        public function areTouching(a:ConvexShape, b:ConvexShape):Boolean
        {
            relate(a, b);
            _cores.maxDistance = _cores.touchingDistance;
            _distance.find(_cores, _witness);
            return _witness.distance <= _cores.touchingDistance;
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
            relate(a, b);
            _cores.maxDistance = out.distance + (a.radius + b.radius);
            _distance.find(_cores, _witness);
            var distance:Number = _witness.distance - (a.radius + b.radius);
            distance = distance > 0 ? distance : 0;
            if (!(distance < out.distance))
            {
                return false;
            }
            writePoints(out);
            return true;
        }

        /**
         * Finds when a moving shape first touches another one. The distance is a convex function of the time. So Newton's method from the left never
         * steps over its first zero (van den Bergen, "Ray casting against general convex objects with application to continuous collision
         * detection", 2004). A step ends when no gap is left along the line between the closest points. Should rounding need more than 80 steps,
         * the time is that of the last step: the shapes do not touch before, and their gap is at most rounding.
         *
         * @param motion the motion of a, and the earliest and the latest time that count; receives the time: 0 if they touch at the beginning, or
         *     RelativeMotion.NEVER
         */
        public function findTime(a:ConvexShape, b:ConvexShape, motion:RelativeMotion):void
        {
            relate(a, b);
            setMotion(motion);
            _from.x = _cores.x;
            _from.y = _cores.y;
            _from.z = _cores.z;
            motion.findMargin();
            _cores.touchingDistance += motion.margin;
            _lastTouch = RelativeMotion.NEVER;
            skipToBalls(motion);
            motion.time = motion.earliest > motion.time ? motion.earliest : motion.time;
            for (var step:int = 0; step < MOST_STEPS && motion.time <= motion.latest; step++)
            {
                _cores.x = _from.x + motion.time * _cores.motionX;
                _cores.y = _from.y + motion.time * _cores.motionY;
                _cores.z = _from.z + motion.time * _cores.motionZ;
                _cores.timeLeft = motion.latest - motion.time;
                if (step == 0)
                {
                    _distance.find(_cores, _witness);
                }
                else
                {
                    _distance.findAgain(_cores, _witness);
                }
                if (!advance(motion))
                {
                    return;
                }
            }
            if (!(motion.time <= motion.latest))
            {
                motion.time = _lastTouch;
            }
        }

        /**
         * Finds the contact of two shapes that touch or overlap: the shortest displacement of a that separates them, and the middle of what they have in
         * common. If several displacements are equally short, CoreOverlap says which it is.
         *
         * @param motion the motion of a; a is where it is at the motion's time
         * @param out receives the contact
         */
        public function findContact(a:ConvexShape, b:ConvexShape, motion:RelativeMotion, out:ContactPoint):void
        {
            beginContact(a, b, motion);
            _distance.find(_cores, _witness);
            if (_witness.distance > Tolerances.GAP * (a.size + b.size))
            {
                out.normalX = _witness.x / _witness.distance;
                out.normalY = _witness.y / _witness.distance;
                out.normalZ = _witness.z / _witness.distance;
                out.depth = -_witness.distance;
            }
            else
            {
                _overlap.find(_cores, out);
                if (_witness.distance > 0)
                {
                    _overlap.tryGap(_cores, _witness, out);
                }
            }
            finishContact(motion, out);
        }

        /** Finds the contact of two shapes whose cores touch or overlap, as findContact() does. It is faster, because it does not find the distance. */
        public function findOverlap(a:ConvexShape, b:ConvexShape, motion:RelativeMotion, out:ContactPoint):void
        {
            beginContact(a, b, motion);
            _overlap.find(_cores, out);
            finishContact(motion, out);
        }

        // Moves the first core to where it is at the motion's time.
        private function beginContact(a:ConvexShape, b:ConvexShape, motion:RelativeMotion):void
        {
            relate(a, b);
            setMotion(motion);
            var time:Number = motion.time;
            _cores.x += time * _cores.motionX;
            _cores.y += time * _cores.motionY;
            _cores.z += time * _cores.motionZ;
            if (!(time > 0))
            {
                _cores.motionX = _cores.motionY = _cores.motionZ = 0;
            }
        }

        // Adds the radii to the depth of the cores, and finds the point.
        private function finishContact(motion:RelativeMotion, out:ContactPoint):void
        {
            var depth:Number = out.depth + (_cores.a.radius + _cores.b.radius);
            out.depth = depth > 0 ? depth : 0;
            _common.find(_cores, out);
            out.x += _cores.b.x;
            out.y += _cores.b.y;
            out.z += _cores.b.z;
            if (_cores.isSwapped)
            {
                out.swapBodies(motion);
            }
        }

        // Puts the two in the order of their places, and sets how near they touch.
        private function relate(a:ConvexShape, b:ConvexShape):void
        {
            var cores:CorePair = _cores;
            var isSwapped:Boolean = isAfter(a, b);
            var first:ConvexShape = isSwapped ? b : a;
            var second:ConvexShape = isSwapped ? a : b;
            // Writing an object to a field costs Adobe's VM more than comparing it first.
            if (cores.a !== first)
            {
                cores.a = first;
            }
            if (cores.b !== second)
            {
                cores.b = second;
            }
            cores.isSwapped = isSwapped;
            cores.x = first.x - second.x;
            cores.y = first.y - second.y;
            cores.z = first.z - second.z;
            cores.maxDistance = cores.timeLeft = Infinity;
            cores.touchingDistance = (first.radius + second.radius) * Tolerances.TOUCHING + (first.margin + second.margin) + Tolerances.CORES * (first.size + second.size);
        }

        // Whether a shape comes after another one: by their places, or at the same place by the numbers that they are made of.
        private static function isAfter(a:ConvexShape, b:ConvexShape):Boolean
        {
            if (a.x != b.x)
            {
                return a.x > b.x;
            }
            if (a.y != b.y)
            {
                return a.y > b.y;
            }
            if (a.z != b.z)
            {
                return a.z > b.z;
            }
            if (a.radius != b.radius || a.end != b.end)
            {
                return a.radius > b.radius || a.radius == b.radius && a.end > b.end;
            }
            for (var i:int = 0; i < a.end; i++)
            {
                if (a.points[i] != b.points[i])
                {
                    return a.points[i] > b.points[i];
                }
            }
            return false;
        }

        // Sets the motion of the first core, and moves it to where the motion begins.
        private function setMotion(motion:RelativeMotion):void
        {
            var cores:CorePair = _cores;
            var side:int = cores.isSwapped ? -1 : 1;
            cores.x += side * motion.startX;
            cores.y += side * motion.startY;
            cores.z += side * motion.startZ;
            cores.motionX = side * motion.x;
            cores.motionY = side * motion.y;
            cores.motionZ = side * motion.z;
        }

        // Sets the motion's time to when balls around the two first meet.
        private function skipToBalls(motion:RelativeMotion):void
        {
            var cores:CorePair = _cores;
            var gap:CoreGap = _gap;
            // the motion is that of the shape that was asked about first
            var side:int = cores.isSwapped ? -1 : 1;
            gap.x = side * cores.x;
            gap.y = side * cores.y;
            gap.z = side * cores.z;
            gap.radiusA = Tolerances.OUTER * (cores.touchingDistance + cores.a.size + cores.b.size);
            gap.radiusB = 0;
            findSphereEntry(gap, motion);
        }

        // Sets the motion's time to that of the next step. If the search ends, sets it to the time of the first touch and returns false.
        private function advance(motion:RelativeMotion):Boolean
        {
            var witness:CoreWitness = _witness;
            var cores:CorePair = _cores;
            var radii:Number = cores.a.radius + cores.b.radius;
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
                refine();
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
        private function refine():void
        {
            var witness:CoreWitness = _witness;
            _overlap.find(_cores, _exact);
            if (-_exact.depth > witness.separation)
            {
                witness.separation = -_exact.depth;
                witness.normalX = _exact.normalX;
                witness.normalY = _exact.normalY;
                witness.normalZ = _exact.normalZ;
            }
        }

        // Writes the distance and the points of the surfaces.
        private function writePoints(out:ClosestPoints):void
        {
            var witness:CoreWitness = _witness;
            var a:ConvexShape = _cores.a;
            var gap:CoreGap = _gap;
            // the vector means nothing if the cores overlap
            var side:int = witness.distance > 0 ? 1 : 0;
            gap.x = side * witness.x;
            gap.y = side * witness.y;
            gap.z = side * witness.z;
            gap.pointX = a.x + witness.pointX;
            gap.pointY = a.y + witness.pointY;
            gap.pointZ = a.z + witness.pointZ;
            gap.radiusA = a.radius;
            gap.radiusB = _cores.b.radius;
            out.setFromGap(gap);
            if (_cores.isSwapped)
            {
                out.swapShapes();
            }
        }
    }
}
