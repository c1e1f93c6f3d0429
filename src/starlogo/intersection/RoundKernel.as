package starlogo.intersection
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.bounding.Capsule;
    import starlogo.bounding.Sphere;
    import starlogo.convex.BallGap;
    import starlogo.convex.ClosestPoints;
    import starlogo.convex.ConservativeAdvancement;
    import starlogo.convex.ContactPoint;
    import starlogo.convex.CoreGap;
    import starlogo.convex.RelativeMotion;
    import starlogo.convex.findTimeOfImpactOfSpheres;
    import starlogo.geometry.Tolerances;

    /**
     * The kernel of a sphere or a capsule and a sphere, a capsule or a box. It answers by the radii and the gap between the two cores: from a sphere's
     * centre or a capsule's axis to another one or to a box. Each pair of cores has a formula for the gap: see RoundGap, SegmentPair and BoxSegment. If
     * there is hardly any gap, the ConvexPairKernel finds the contact.
     *
     * <p>Two spheres have a closed form for the time of impact. The steps of others are those of all convex shapes: see ConservativeAdvancement. Here a
     * formula gives the gap of each. With hardly any radius the last gaps are so short that rounding hides their direction, so the ConvexPairKernel finds
     * the time.</p>
     *
     * <p>The formulas are in one class, because a call that meets more than four classes is slow in V8.</p>
     *
     * @private
     */
    public final class RoundKernel extends StructurePairKernel
    {
        private var _convex:ConvexPairKernel;

        // What findGap() writes: the gap, and the cores that it is between, at the motion's time. They are two axes, or an axis as seen from a box.
        private var _gap:RoundGap = new RoundGap();
        private var _axes:SegmentPair = new SegmentPair();
        private var _axisAtBox:BoxSegment = new BoxSegment();

        // The gap of two spheres.
        private var _balls:BallGap = new BallGap();

        private var _step:ConservativeAdvancement = new ConservativeAdvancement();

        /** @param convex finds the contact if there is hardly any gap, and the time of impact if there is hardly any radius */
        public function RoundKernel(convex:ConvexPairKernel)
        {
            _convex = convex;
        }

        /** @inheritDoc */
        override public function findTimeOfImpact(a:BoundingStructure, b:BoundingStructure, motion:RelativeMotion):void
        {
            var gap:RoundGap = _gap;
            motion.time = 0;
            if (b.kind == BoundingStructure.SPHERE)
            {
                findGap(a, b, motion, gap);
                var cores:CoreGap = gap.cores;
                _balls.x = cores.x;
                _balls.y = cores.y;
                _balls.z = cores.z;
                _balls.touchDistance = cores.radiusA + cores.radiusB;
                findTimeOfImpactOfSpheres(_balls, motion);
                return;
            }
            var margins:Number = motion.margin;
            _step.reset();
            do
            {
                findGap(a, b, motion, gap);
                var radii:Number = gap.cores.radiusA + gap.cores.radiusB;
                var touchingDistance:Number = radii * Tolerances.TOUCHING + margins;
                var length:Number = Math.sqrt(gap.squaredLength);
                _step.isTouching = gap.squaredLength <= touchingDistance * touchingDistance;
                if (!_step.isTouching && radii < Tolerances.DIRECTION * gap.size)
                {
                    _convex.findTimeOfImpact(a, b, motion);
                    return;
                }
                _step.separation = length - radii;
                _step.speed = gap.closingSpeedTimesLength / length;
            }
            while (_step.advance(motion));
        }

        /** @inheritDoc */
        override public function findContact(a:BoundingStructure, b:BoundingStructure, motion:RelativeMotion, out:ContactPoint):void
        {
            var gap:RoundGap = _gap;
            findGap(a, b, motion, gap);
            // If the gap is longer than this, it has a direction in spite of rounding.
            var least:Number = Tolerances.DIRECTION * gap.size;
            if (gap.squaredLength > least * least)
            {
                // of the points of an axis that are equally close, the one in the middle
                if (a.kind == BoundingStructure.CAPSULE && b.kind == BoundingStructure.CAPSULE)
                {
                    _axes.moveToMiddle(gap);
                }
                else if (a.kind == BoundingStructure.CAPSULE)
                {
                    _axisAtBox.moveToMiddle(gap);
                }
                setPoint(a, gap);
                out.setFromGap(gap.cores, motion);
            }
            else if (gap.squaredLength > 0)
            {
                _convex.findContact(a, b, motion, out);
            }
            else
            {
                _convex.findOverlap(a, b, motion, out);
            }
        }

        /** @inheritDoc */
        override public function findClosest(a:BoundingStructure, b:BoundingStructure, out:ClosestPoints):void
        {
            findGap(a, b, RelativeMotion.NONE, _gap);
            setPoint(a, _gap);
            out.setFromGap(_gap.cores);
        }

        // Finds the gap at the motion's time, except for its point: setPoint() sets that. a is a sphere or a capsule.
        private function findGap(a:BoundingStructure, b:BoundingStructure, motion:RelativeMotion, out:RoundGap):void
        {
            if (b.kind == BoundingStructure.SPHERE)
            {
                findGapOfCenters(a as Sphere, b as Sphere, motion, out);
            }
            else if (b.kind == BoundingStructure.CAPSULE)
            {
                findGapOfAxes(a, b as Capsule, motion, out);
            }
            else
            {
                findGapToBox(a, b as Box, motion, out);
            }
        }

        // Sets the gap's point: the closest point of a's core.
        private static function setPoint(a:BoundingStructure, gap:RoundGap):void
        {
            var point:Vector3D = gap.cores.point;
            if (a.kind == BoundingStructure.SPHERE)
            {
                point.copyFrom((a as Sphere).center);
                return;
            }
            var start:Vector3D = (a as Capsule).start;
            var end:Vector3D = (a as Capsule).end;
            point.x = start.x + gap.fraction * (end.x - start.x);
            point.y = start.y + gap.fraction * (end.y - start.y);
            point.z = start.z + gap.fraction * (end.z - start.z);
        }

        private static function findGapOfCenters(a:Sphere, b:Sphere, motion:RelativeMotion, out:RoundGap):void
        {
            var gap:CoreGap = out.cores;
            gap.x = a.center.x - b.center.x + motion.startX + motion.time * motion.x;
            gap.y = a.center.y - b.center.y + motion.startY + motion.time * motion.y;
            gap.z = a.center.z - b.center.z + motion.startZ + motion.time * motion.z;
            gap.radiusA = a.radius;
            gap.radiusB = b.radius;
            out.size = a.radius + b.radius;
            out.squaredLength = gap.x * gap.x + gap.y * gap.y + gap.z * gap.z;
        }

        // The axis of a sphere is its centre, a segment without length.
        private function findGapOfAxes(a:BoundingStructure, b:Capsule, motion:RelativeMotion, out:RoundGap):void
        {
            var gap:CoreGap = out.cores;
            var axes:SegmentPair = _axes;
            var isSphere:Boolean = a.kind == BoundingStructure.SPHERE;
            var start:Vector3D = isSphere ? (a as Sphere).center : (a as Capsule).start;
            axes.setTo(start, isSphere ? start : (a as Capsule).end, motion, b.start, b.end);
            axes.findGap(out);
            gap.radiusA = isSphere ? (a as Sphere).radius : (a as Capsule).radius;
            gap.radiusB = b.radius;
            out.size = gap.radiusA + Math.abs(axes.u.x) + Math.abs(axes.u.y) + Math.abs(axes.u.z) + Math.abs(axes.v.x) + Math.abs(axes.v.y) + Math.abs(axes.v.z) + gap.radiusB;
            out.closingSpeedTimesLength = -(gap.x * motion.x + gap.y * motion.y + gap.z * motion.z);
        }

        private function findGapToBox(a:BoundingStructure, b:Box, motion:RelativeMotion, out:RoundGap):void
        {
            var gap:CoreGap = out.cores;
            if (a.kind == BoundingStructure.SPHERE)
            {
                gap.radiusA = out.size = (a as Sphere).radius;
                placeCenter((a as Sphere).center, b, motion, out.place);
            }
            else
            {
                var axis:BoxSegment = _axisAtBox;
                axis.setTo(a as Capsule, b);
                axis.move(b, motion);
                axis.findClosest(out);
                gap.radiusA = (a as Capsule).radius;
                out.size = gap.radiusA + Math.abs(axis.along[0]) + Math.abs(axis.along[1]) + Math.abs(axis.along[2]);
            }
            var x:Number = out.place.x;
            var y:Number = out.place.y;
            var z:Number = out.place.z;
            x = x > b.halfX ? x - b.halfX : (x < -b.halfX ? x + b.halfX : 0);
            y = y > b.halfY ? y - b.halfY : (y < -b.halfY ? y + b.halfY : 0);
            z = z > b.halfZ ? z - b.halfZ : (z < -b.halfZ ? z + b.halfZ : 0);
            gap.x = x * b.axisX.x + y * b.axisY.x + z * b.axisZ.x;
            gap.y = x * b.axisX.y + y * b.axisY.y + z * b.axisZ.y;
            gap.z = x * b.axisX.z + y * b.axisY.z + z * b.axisZ.z;
            gap.radiusB = 0;
            out.size += b.halfX + b.halfY + b.halfZ;
            out.squaredLength = x * x + y * y + z * z;
            out.closingSpeedTimesLength = -(x * (b.axisX.x * motion.x + b.axisX.y * motion.y + b.axisX.z * motion.z)
                    + y * (b.axisY.x * motion.x + b.axisY.y * motion.y + b.axisY.z * motion.z)
                    + z * (b.axisZ.x * motion.x + b.axisZ.y * motion.y + b.axisZ.z * motion.z));
        }

        // Writes the place of a sphere's centre, as seen from a box.
        private static function placeCenter(center:Vector3D, box:Box, motion:RelativeMotion, out:Vector3D):void
        {
            var x:Number = center.x - box.center.x + motion.startX;
            var y:Number = center.y - box.center.y + motion.startY;
            var z:Number = center.z - box.center.z + motion.startZ;
            var time:Number = motion.time;
            var axis:Vector3D = box.axisX;
            out.x = axis.x * x + axis.y * y + axis.z * z + time * (axis.x * motion.x + axis.y * motion.y + axis.z * motion.z);
            axis = box.axisY;
            out.y = axis.x * x + axis.y * y + axis.z * z + time * (axis.x * motion.x + axis.y * motion.y + axis.z * motion.z);
            axis = box.axisZ;
            out.z = axis.x * x + axis.y * y + axis.z * z + time * (axis.x * motion.x + axis.y * motion.y + axis.z * motion.z);
        }
    }
}
