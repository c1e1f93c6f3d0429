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

        private var _step:ConservativeAdvancement = new ConservativeAdvancement();

        /** @param convex finds the contact if there is hardly any gap, and the time of impact if there is hardly any radius */
        public function RoundKernel(convex:ConvexPairKernel)
        {
            _convex = convex;
        }

        /** @inheritDoc */
        override public function findTimeOfImpact(a:BoundingStructure, b:BoundingStructure, motion:RelativeMotion):void
        {
            var step:ConservativeAdvancement = _step;
            var gap:RoundGap = _gap;
            var margins:Number = motion.margin;
            motion.time = 0;
            if (b.kind == BoundingStructure.SPHERE)
            {
                findGap(a, b, motion, gap);
                findTimeOfImpactOfSpheres(gap.cores, motion);
                return;
            }
            step.reset();
            do
            {
                findGap(a, b, motion, gap);
                var radii:Number = gap.cores.radiusA + gap.cores.radiusB;
                var touchingDistance:Number = radii * Tolerances.TOUCHING + margins;
                var length:Number = Math.sqrt(gap.squaredLength);
                step.isTouching = gap.squaredLength <= touchingDistance * touchingDistance;
                if (!step.isTouching && radii < Tolerances.DIRECTION * gap.size)
                {
                    _convex.findTimeOfImpact(a, b, motion);
                    return;
                }
                step.separation = length - radii;
                step.speed = gap.closingSpeedTimesLength / length;
            }
            while (step.advance(motion));
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
            var isSphere:Boolean = a.kind == BoundingStructure.SPHERE;
            out.cores.radiusA = out.size = isSphere ? (a as Sphere).radius : (a as Capsule).radius;
            if (b.kind != BoundingStructure.BOX)
            {
                measureToAxis(a, b, motion, out);
                return;
            }
            if (isSphere)
            {
                placeCenter((a as Sphere).center, b as Box, motion, out);
            }
            else
            {
                _axisAtBox.setTo(a as Capsule, b as Box);
                _axisAtBox.move(b as Box, motion);
                _axisAtBox.findClosest(out);
                out.size += Math.abs(_axisAtBox.along[0]) + Math.abs(_axisAtBox.along[1]) + Math.abs(_axisAtBox.along[2]);
            }
            measureToBox(b as Box, motion, out);
        }

        // The axis of a sphere or a capsule goes from its start to its end. That of a sphere is its centre, a segment without length.
        private static function startOf(round:BoundingStructure):Vector3D
        {
            return round.kind == BoundingStructure.SPHERE ? (round as Sphere).center : (round as Capsule).start;
        }

        private static function endOf(round:BoundingStructure):Vector3D
        {
            return round.kind == BoundingStructure.SPHERE ? (round as Sphere).center : (round as Capsule).end;
        }

        // Sets the gap's point: the closest point of a's core.
        private static function setPoint(a:BoundingStructure, gap:RoundGap):void
        {
            var point:Vector3D = gap.cores.point;
            var start:Vector3D = startOf(a);
            var end:Vector3D = endOf(a);
            point.x = start.x + gap.fraction * (end.x - start.x);
            point.y = start.y + gap.fraction * (end.y - start.y);
            point.z = start.z + gap.fraction * (end.z - start.z);
        }

        // Measures the gap between two axes.
        private function measureToAxis(a:BoundingStructure, b:BoundingStructure, motion:RelativeMotion, out:RoundGap):void
        {
            var gap:CoreGap = out.cores;
            var axes:SegmentPair = _axes;
            axes.setTo(startOf(a), endOf(a), motion, startOf(b), endOf(b));
            axes.findGap(out);
            gap.radiusB = b.kind == BoundingStructure.SPHERE ? (b as Sphere).radius : (b as Capsule).radius;
            out.size += Math.abs(axes.u.x) + Math.abs(axes.u.y) + Math.abs(axes.u.z) + Math.abs(axes.v.x) + Math.abs(axes.v.y) + Math.abs(axes.v.z) + gap.radiusB;
            out.closingSpeedTimesLength = -(gap.x * motion.x + gap.y * motion.y + gap.z * motion.z);
        }

        // Finds the place of a sphere's centre as seen from a box.
        private static function placeCenter(center:Vector3D, box:Box, motion:RelativeMotion, out:RoundGap):void
        {
            var place:Vector3D = out.place;
            var x:Number = center.x - box.center.x + motion.startX;
            var y:Number = center.y - box.center.y + motion.startY;
            var z:Number = center.z - box.center.z + motion.startZ;
            var time:Number = motion.time;
            var axis:Vector3D = box.axisX;
            place.x = axis.x * x + axis.y * y + axis.z * z + time * (axis.x * motion.x + axis.y * motion.y + axis.z * motion.z);
            axis = box.axisY;
            place.y = axis.x * x + axis.y * y + axis.z * z + time * (axis.x * motion.x + axis.y * motion.y + axis.z * motion.z);
            axis = box.axisZ;
            place.z = axis.x * x + axis.y * y + axis.z * z + time * (axis.x * motion.x + axis.y * motion.y + axis.z * motion.z);
            out.fraction = 0;
        }

        // Measures the gap between the closest point, whose place is known, and a box.
        private static function measureToBox(box:Box, motion:RelativeMotion, out:RoundGap):void
        {
            var gap:CoreGap = out.cores;
            var axisX:Vector3D = box.axisX;
            var axisY:Vector3D = box.axisY;
            var axisZ:Vector3D = box.axisZ;
            var x:Number = out.place.x;
            var y:Number = out.place.y;
            var z:Number = out.place.z;
            x = x > box.halfX ? x - box.halfX : (x < -box.halfX ? x + box.halfX : 0);
            y = y > box.halfY ? y - box.halfY : (y < -box.halfY ? y + box.halfY : 0);
            z = z > box.halfZ ? z - box.halfZ : (z < -box.halfZ ? z + box.halfZ : 0);
            gap.x = x * axisX.x + y * axisY.x + z * axisZ.x;
            gap.y = x * axisX.y + y * axisY.y + z * axisZ.y;
            gap.z = x * axisX.z + y * axisY.z + z * axisZ.z;
            gap.radiusB = 0;
            out.size += box.halfX + box.halfY + box.halfZ;
            out.squaredLength = x * x + y * y + z * z;
            out.closingSpeedTimesLength = -(x * (axisX.x * motion.x + axisX.y * motion.y + axisX.z * motion.z)
                    + y * (axisY.x * motion.x + axisY.y * motion.y + axisY.z * motion.z)
                    + z * (axisZ.x * motion.x + axisZ.y * motion.y + axisZ.z * motion.z));
        }
    }
}
