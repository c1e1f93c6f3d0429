package starlogo.intersection
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.bounding.Capsule;
    import starlogo.bounding.Sphere;
    import starlogo.convex.CoreGap;
    import starlogo.convex.RelativeMotion;

    /**
     * Finds the gap between the cores of two structures, by which RoundKernel answers its questions: from a sphere's centre or a capsule's axis to a
     * capsule's axis or a box. Each pair of kinds has a formula. They are in one class, because a call that meets more than
     * four classes is slow in V8.
     */
    internal final class GapFinder
    {
        private var _segments:SegmentPair = new SegmentPair();
        private var _segment:BoxSegment = new BoxSegment();

        // A place as seen from a box's middle, in the box's axes.
        private var _place:Vector3D = new Vector3D();

        /**
         * Finds the gap.
         *
         * @param a a sphere or a capsule
         * @param b a capsule or a box, in the same space
         * @param motion the motion of a; a is where it is at the motion's time
         * @param out receives all of the gap
         */
        public function find(a:BoundingStructure, b:BoundingStructure, motion:RelativeMotion, out:CoreGap):void
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

        /** Finds the gap as <code>find()</code>, but from the middle of the points of a that are equally close. Only contacts need it. */
        public function findCentered(a:BoundingStructure, b:BoundingStructure, motion:RelativeMotion, out:CoreGap):void
        {
            find(a, b, motion, out);
            var capsule:Capsule = a as Capsule;
            if (capsule != null)
            {
                setPoint(capsule, b.kind == BoundingStructure.CAPSULE ? _segments.middleOfU : _segment.middleIn(b as Box), out);
            }
        }

        // Sets the closest point of a capsule's axis.
        private static function setPoint(capsule:Capsule, fraction:Number, gap:CoreGap):void
        {
            var start:Vector3D = capsule.start;
            var end:Vector3D = capsule.end;
            gap.pointX = start.x + fraction * (end.x - start.x);
            gap.pointY = start.y + fraction * (end.y - start.y);
            gap.pointZ = start.z + fraction * (end.z - start.z);
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
            out.pointX = start.x + segments.fractionOfU * segments.uX;
            out.pointY = start.y + segments.fractionOfU * segments.uY;
            out.pointZ = start.z + segments.fractionOfU * segments.uZ;
            out.radiusB = b.radius;
            out.size = Math.abs(segments.uX) + Math.abs(segments.uY) + Math.abs(segments.uZ) + (Math.abs(segments.vX) + Math.abs(segments.vY) + Math.abs(segments.vZ))
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
            out.pointX = center.x;
            out.pointY = center.y;
            out.pointZ = center.z;
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
            place.x = segment.x + fraction * segment.alongX;
            place.y = segment.y + fraction * segment.alongY;
            place.z = segment.z + fraction * segment.alongZ;
            measureToBox(place, box, motion, out);
            setPoint(capsule, fraction, out);
            out.radiusA = capsule.radius;
            out.size = Math.abs(segment.alongX) + Math.abs(segment.alongY) + Math.abs(segment.alongZ) + box.halfX + box.halfY + box.halfZ + capsule.radius;
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
