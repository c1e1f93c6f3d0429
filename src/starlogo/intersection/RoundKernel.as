package starlogo.intersection
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.bounding.Capsule;
    import starlogo.bounding.Sphere;
    import starlogo.convex.ClosestPoints;
    import starlogo.convex.ConservativeAdvancement;
    import starlogo.convex.ContactPoint;
    import starlogo.convex.CoreGap;
    import starlogo.convex.RelativeMotion;
    import starlogo.geometry.Tolerances;

    /**
     * The kernel of two structures of which at least one is a sphere or a capsule, except for two spheres. It answers by the radii and the gap between
     * the two cores: from a sphere's centre or a capsule's axis to a capsule's axis or a box. Each pair of kinds has a formula for the gap. If there is
     * hardly any gap, the ConvexPairKernel finds the contact.
     *
     * <p>The steps to the time of impact are those of all convex shapes: see ConservativeAdvancement. Here a formula gives the gap of each. With hardly any
     * radius the last gaps are so short that rounding hides their direction, so the ConvexPairKernel finds the time.</p>
     *
     * <p>The formulas are in one class, because a call that meets more than four classes is slow in V8.</p>
     *
     * @private
     */
    public final class RoundKernel extends StructurePairKernel
    {
        private var _convex:ConvexPairKernel;

        // The gap at the motion's time, which findGap() finds. Its squared length, which at a box is more precise than the vector; how fast the motion
        // closes it, times its length; and the size of both structures together, which its rounding error is relative to.
        private var _gap:CoreGap = new CoreGap();
        private var _squaredLength:Number = 0;
        private var _closingSpeedTimesLength:Number = 0;
        private var _size:Number = 0;

        private var _segmentPair:SegmentPair = new SegmentPair();
        private var _boxSegment:BoxSegment = new BoxSegment();

        // A place as seen from a box's middle, in the box's axes.
        private var _place:Vector3D = new Vector3D();

        private var _step:ConservativeAdvancement = new ConservativeAdvancement();

        /** @param convex finds the contact if there is hardly any gap, and the time of impact if there is hardly any radius */
        public function RoundKernel(convex:ConvexPairKernel)
        {
            _convex = convex;
        }

        /** @inheritDoc */
        override internal function findTimeOfImpactInOrder(first:BoundingStructure, second:BoundingStructure, motion:RelativeMotion):void
        {
            var step:ConservativeAdvancement = _step;
            var margins:Number = motion.margin;
            motion.time = 0;
            step.reset();
            do
            {
                findGap(first, second, motion);
                var radii:Number = _gap.radiusA + _gap.radiusB;
                var touchingDistance:Number = radii * Tolerances.TOUCHING + margins;
                var length:Number = Math.sqrt(_squaredLength);
                step.isTouching = _squaredLength <= touchingDistance * touchingDistance;
                if (!step.isTouching && radii < Tolerances.DIRECTION * _size)
                {
                    _convex.findTimeOfImpactInOrder(first, second, motion);
                    return;
                }
                step.separation = length - radii;
                step.speed = _closingSpeedTimesLength / length;
            }
            while (step.advance(motion));
        }

        /** @inheritDoc */
        override internal function findContactInOrder(first:BoundingStructure, second:BoundingStructure, motion:RelativeMotion, out:ContactPoint):void
        {
            findGap(first, second, motion);
            // If the gap is longer than this, it has a direction in spite of rounding.
            var least:Number = Tolerances.DIRECTION * _size;
            if (_squaredLength > least * least)
            {
                if (first.kind == BoundingStructure.CAPSULE)
                {
                    // of the points of its axis that are equally close, the one in the middle
                    setPoint(first as Capsule, second.kind == BoundingStructure.CAPSULE ? _segmentPair.middleOfU : _boxSegment.middleIn(second as Box));
                }
                out.setFromGap(_gap, motion);
            }
            else if (_squaredLength > 0)
            {
                _convex.findContactInOrder(first, second, motion, out);
            }
            else
            {
                _convex.findOverlapInOrder(first, second, motion, out);
            }
        }

        /** @inheritDoc */
        override internal function findClosestInOrder(first:BoundingStructure, second:BoundingStructure, out:ClosestPoints):void
        {
            findGap(first, second, RelativeMotion.NONE);
            out.setFromGap(_gap);
        }

        // Finds the gap at the motion's time. a is a sphere or a capsule; b is a capsule or a box.
        private function findGap(a:BoundingStructure, b:BoundingStructure, motion:RelativeMotion):void
        {
            if (b.kind == BoundingStructure.CAPSULE)
            {
                findFromAxis(a, b as Capsule, motion);
            }
            else if (a.kind == BoundingStructure.SPHERE)
            {
                findFromSphereToBox(a as Sphere, b as Box, motion);
            }
            else
            {
                findFromCapsuleToBox(a as Capsule, b as Box, motion);
            }
        }

        // Sets the closest point of a capsule's axis.
        private function setPoint(capsule:Capsule, fraction:Number):void
        {
            var point:Vector3D = _gap.point;
            var start:Vector3D = capsule.start;
            var end:Vector3D = capsule.end;
            point.x = start.x + fraction * (end.x - start.x);
            point.y = start.y + fraction * (end.y - start.y);
            point.z = start.z + fraction * (end.z - start.z);
        }

        // The axis of a sphere is its centre, a segment without length.
        private function findFromAxis(a:BoundingStructure, b:Capsule, motion:RelativeMotion):void
        {
            var gap:CoreGap = _gap;
            var segments:SegmentPair = _segmentPair;
            var isSphere:Boolean = a.kind == BoundingStructure.SPHERE;
            var start:Vector3D = isSphere ? (a as Sphere).center : (a as Capsule).start;
            segments.setTo(start, isSphere ? start : (a as Capsule).end, b);
            gap.radiusA = isSphere ? (a as Sphere).radius : (a as Capsule).radius;
            segments.move(motion);
            segments.findClosest(gap);
            _squaredLength = gap.x * gap.x + gap.y * gap.y + gap.z * gap.z;
            _closingSpeedTimesLength = -(gap.x * motion.x + gap.y * motion.y + gap.z * motion.z);
            gap.point.x = start.x + segments.fractionOfU * segments.u.x;
            gap.point.y = start.y + segments.fractionOfU * segments.u.y;
            gap.point.z = start.z + segments.fractionOfU * segments.u.z;
            gap.radiusB = b.radius;
            _size = Math.abs(segments.u.x) + Math.abs(segments.u.y) + Math.abs(segments.u.z) + (Math.abs(segments.v.x) + Math.abs(segments.v.y) + Math.abs(segments.v.z))
                + (gap.radiusA + gap.radiusB);
        }

        private function findFromSphereToBox(sphere:Sphere, box:Box, motion:RelativeMotion):void
        {
            var place:Vector3D = _place;
            var center:Vector3D = sphere.center;
            var boxCenter:Vector3D = box.center;
            var x:Number = center.x - boxCenter.x + motion.startX;
            var y:Number = center.y - boxCenter.y + motion.startY;
            var z:Number = center.z - boxCenter.z + motion.startZ;
            var time:Number = motion.time;
            var axis:Vector3D = box.axisX;
            place.x = axis.x * x + axis.y * y + axis.z * z + time * (axis.x * motion.x + axis.y * motion.y + axis.z * motion.z);
            axis = box.axisY;
            place.y = axis.x * x + axis.y * y + axis.z * z + time * (axis.x * motion.x + axis.y * motion.y + axis.z * motion.z);
            axis = box.axisZ;
            place.z = axis.x * x + axis.y * y + axis.z * z + time * (axis.x * motion.x + axis.y * motion.y + axis.z * motion.z);
            measureToBox(box, motion);
            _gap.point.copyFrom(center);
            _gap.radiusA = sphere.radius;
            _size = box.halfX + box.halfY + box.halfZ + sphere.radius;
        }

        private function findFromCapsuleToBox(capsule:Capsule, box:Box, motion:RelativeMotion):void
        {
            var segment:BoxSegment = _boxSegment;
            var place:Vector3D = _place;
            segment.setTo(capsule, box);
            segment.move(box, motion);
            segment.findClosest(box);
            var fraction:Number = segment.fraction;
            place.x = segment.start.x + fraction * segment.along.x;
            place.y = segment.start.y + fraction * segment.along.y;
            place.z = segment.start.z + fraction * segment.along.z;
            measureToBox(box, motion);
            setPoint(capsule, fraction);
            _gap.radiusA = capsule.radius;
            _size = Math.abs(segment.along.x) + Math.abs(segment.along.y) + Math.abs(segment.along.z) + box.halfX + box.halfY + box.halfZ + capsule.radius;
        }

        // Computes the gap between the place and the nearest point of the box, its squared length, and how a motion of the place closes it.
        private function measureToBox(box:Box, motion:RelativeMotion):void
        {
            var gap:CoreGap = _gap;
            var axisX:Vector3D = box.axisX;
            var axisY:Vector3D = box.axisY;
            var axisZ:Vector3D = box.axisZ;
            var x:Number = _place.x;
            var y:Number = _place.y;
            var z:Number = _place.z;
            x = x > box.halfX ? x - box.halfX : (x < -box.halfX ? x + box.halfX : 0);
            y = y > box.halfY ? y - box.halfY : (y < -box.halfY ? y + box.halfY : 0);
            z = z > box.halfZ ? z - box.halfZ : (z < -box.halfZ ? z + box.halfZ : 0);
            gap.x = x * axisX.x + y * axisY.x + z * axisZ.x;
            gap.y = x * axisX.y + y * axisY.y + z * axisZ.y;
            gap.z = x * axisX.z + y * axisY.z + z * axisZ.z;
            gap.radiusB = 0;
            _squaredLength = x * x + y * y + z * z;
            _closingSpeedTimesLength = -(x * (axisX.x * motion.x + axisX.y * motion.y + axisX.z * motion.z)
                    + y * (axisY.x * motion.x + axisY.y * motion.y + axisY.z * motion.z)
                    + z * (axisZ.x * motion.x + axisZ.y * motion.y + axisZ.z * motion.z));
        }
    }
}
