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
        private var _gap:CoreGap = new CoreGap();
        private var _segments:SegmentPair = new SegmentPair();
        private var _segment:BoxSegment = new BoxSegment();

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
            var gap:CoreGap = _gap;
            var step:ConservativeAdvancement = _step;
            var margins:Number = motion.margin;
            motion.time = 0;
            step.reset();
            do
            {
                findGap(first, second, motion, gap);
                var radii:Number = gap.radiusA + gap.radiusB;
                var touchingDistance:Number = radii * Tolerances.TOUCHING + margins;
                var length:Number = Math.sqrt(gap.squaredLength);
                step.isTouching = gap.squaredLength <= touchingDistance * touchingDistance;
                if (!step.isTouching && radii < Tolerances.DIRECTION * gap.size)
                {
                    _convex.findTimeOfImpactInOrder(first, second, motion);
                    return;
                }
                step.separation = length - radii;
                step.speed = gap.closingSpeedTimesLength / length;
            }
            while (step.advance(motion));
        }

        /** @inheritDoc */
        override internal function findContactInOrder(first:BoundingStructure, second:BoundingStructure, motion:RelativeMotion, out:ContactPoint):void
        {
            var gap:CoreGap = _gap;
            findGap(first, second, motion, gap);
            // If the gap is longer than this, it has a direction in spite of rounding.
            var least:Number = Tolerances.DIRECTION * gap.size;
            if (gap.squaredLength > least * least)
            {
                if (first.kind == BoundingStructure.CAPSULE)
                {
                    // of the points of its axis that are equally close, the one in the middle
                    setPoint(first as Capsule, second.kind == BoundingStructure.CAPSULE ? _segments.middleOfU : _segment.middleIn(second as Box), gap);
                }
                out.setFromGap(gap, motion);
            }
            else if (gap.squaredLength > 0)
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
            findGap(first, second, RelativeMotion.NONE, _gap);
            out.setFromGap(_gap);
        }

        // Finds the gap at the motion's time. a is a sphere or a capsule; b is a capsule or a box.
        private function findGap(a:BoundingStructure, b:BoundingStructure, motion:RelativeMotion, out:CoreGap):void
        {
            if (b.kind == BoundingStructure.CAPSULE)
            {
                findFromAxis(a, b as Capsule, motion, out);
            }
            else if (a.kind == BoundingStructure.SPHERE)
            {
                findFromSphereToBox(a as Sphere, b as Box, motion, out);
            }
            else
            {
                findFromCapsuleToBox(a as Capsule, b as Box, motion, out);
            }
        }

        // Sets the closest point of a capsule's axis.
        private static function setPoint(capsule:Capsule, fraction:Number, gap:CoreGap):void
        {
            var start:Vector3D = capsule.start;
            var end:Vector3D = capsule.end;
            gap.point.x = start.x + fraction * (end.x - start.x);
            gap.point.y = start.y + fraction * (end.y - start.y);
            gap.point.z = start.z + fraction * (end.z - start.z);
        }

        // The axis of a sphere is its centre, a segment without length.
        private function findFromAxis(a:BoundingStructure, b:Capsule, motion:RelativeMotion, out:CoreGap):void
        {
            var segments:SegmentPair = _segments;
            var isSphere:Boolean = a.kind == BoundingStructure.SPHERE;
            var start:Vector3D = isSphere ? (a as Sphere).center : (a as Capsule).start;
            segments.setTo(start, isSphere ? start : (a as Capsule).end, b);
            out.radiusA = isSphere ? (a as Sphere).radius : (a as Capsule).radius;
            segments.move(motion);
            segments.findClosest(out);
            out.squaredLength = out.x * out.x + out.y * out.y + out.z * out.z;
            out.closingSpeedTimesLength = -(out.x * motion.x + out.y * motion.y + out.z * motion.z);
            out.point.x = start.x + segments.fractionOfU * segments.u.x;
            out.point.y = start.y + segments.fractionOfU * segments.u.y;
            out.point.z = start.z + segments.fractionOfU * segments.u.z;
            out.radiusB = b.radius;
            out.size = Math.abs(segments.u.x) + Math.abs(segments.u.y) + Math.abs(segments.u.z) + (Math.abs(segments.v.x) + Math.abs(segments.v.y) + Math.abs(segments.v.z))
                + (out.radiusA + out.radiusB);
        }

        private function findFromSphereToBox(sphere:Sphere, box:Box, motion:RelativeMotion, out:CoreGap):void
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
            measureToBox(place, box, motion, out);
            out.point.copyFrom(center);
            out.radiusA = sphere.radius;
            out.size = box.halfX + box.halfY + box.halfZ + sphere.radius;
        }

        private function findFromCapsuleToBox(capsule:Capsule, box:Box, motion:RelativeMotion, out:CoreGap):void
        {
            var segment:BoxSegment = _segment;
            var place:Vector3D = _place;
            segment.setTo(capsule, box);
            segment.move(box, motion);
            segment.findClosest(box);
            var fraction:Number = segment.fraction;
            place.x = segment.start.x + fraction * segment.along.x;
            place.y = segment.start.y + fraction * segment.along.y;
            place.z = segment.start.z + fraction * segment.along.z;
            measureToBox(place, box, motion, out);
            setPoint(capsule, fraction, out);
            out.radiusA = capsule.radius;
            out.size = Math.abs(segment.along.x) + Math.abs(segment.along.y) + Math.abs(segment.along.z) + box.halfX + box.halfY + box.halfZ + capsule.radius;
        }

        // Computes the gap between a place and the nearest point of a box, its squared length, and how a motion of the place closes it.
        private static function measureToBox(place:Vector3D, box:Box, motion:RelativeMotion, out:CoreGap):void
        {
            var axisX:Vector3D = box.axisX;
            var axisY:Vector3D = box.axisY;
            var axisZ:Vector3D = box.axisZ;
            var x:Number = place.x;
            var y:Number = place.y;
            var z:Number = place.z;
            x = x > box.halfX ? x - box.halfX : (x < -box.halfX ? x + box.halfX : 0);
            y = y > box.halfY ? y - box.halfY : (y < -box.halfY ? y + box.halfY : 0);
            z = z > box.halfZ ? z - box.halfZ : (z < -box.halfZ ? z + box.halfZ : 0);
            out.x = x * axisX.x + y * axisY.x + z * axisZ.x;
            out.y = x * axisX.y + y * axisY.y + z * axisZ.y;
            out.z = x * axisX.z + y * axisY.z + z * axisZ.z;
            out.radiusB = 0;
            out.squaredLength = x * x + y * y + z * z;
            out.closingSpeedTimesLength = -(x * (axisX.x * motion.x + axisX.y * motion.y + axisX.z * motion.z)
                    + y * (axisY.x * motion.x + axisY.y * motion.y + axisY.z * motion.z)
                    + z * (axisZ.x * motion.x + axisZ.y * motion.y + axisZ.z * motion.z));
        }
    }
}
