package starlogo.intersection
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.bounding.Capsule;
    import starlogo.convex.ClosestPoints;
    import starlogo.convex.ContactPoint;
    import starlogo.convex.RelativeMotion;
    import starlogo.geometry.Tolerances;
    import starlogo.intersection.contact.LeastOverlap;
    import starlogo.intersection.contact.placeContact;
    import starlogo.intersection.distance.RoundGap;
    import starlogo.intersection.distance.moveToSurfaces;
    import starlogo.intersection.sweep.NewtonSteps;

    /** The kernel of a capsule and a box. It works in the box's axes, mirrored so that no component of the capsule's axis is negative. */
    internal final class CapsuleBoxKernel extends PairKernel
    {
        // The motion of the start of the capsule's axis as seen from the box's middle, in the mirrored axes.
        private var _way:RelativeMotion = new RelativeMotion();
        private var _axis:BoxSegment = new BoxSegment();
        private var _gap:RoundGap = new RoundGap();
        private var _steps:NewtonSteps = new NewtonSteps();
        private var _overlap:LeastOverlap = new LeastOverlap();

        /** @inheritDoc */
        override public function findTime(a:BoundingStructure, b:BoundingStructure, motion:RelativeMotion):void
        {
            relate(a as Capsule, b as Box, motion);
            if (_steps.begin(motion, _way, _gap))
            {
                measure();
                do
                {
                    findGap();
                }
                while (_steps.next(_way, _gap));
            }
            motion.time = _way.time;
        }

        /** @inheritDoc */
        override public function findContact(a:BoundingStructure, b:BoundingStructure, displacement:RelativeMotion, out:ContactPoint):void
        {
            var capsule:Capsule = a as Capsule;
            var box:Box = b as Box;
            relate(capsule, box, displacement);
            measure();
            var gap:RoundGap = _gap;
            var squared:Number = gap.x * gap.x + gap.y * gap.y + gap.z * gap.z;
            // If the gap is longer than this, it has a direction in spite of rounding.
            var least:Number = Tolerances.DIRECTION * gap.size;
            if (!(squared > least * least))
            {
                _overlap.findContact(a, b, displacement, out);
                return;
            }
            rotateGap(box);
            out.setNormal(gap.x, gap.y, gap.z);
            out.normalise();
            out.depth = gap.radiusA - Math.sqrt(squared);
            var start:Vector3D = capsule.start;
            var end:Vector3D = capsule.end;
            out.x = displacement.startX + start.x + gap.share * (end.x - start.x);
            out.y = displacement.startY + start.y + gap.share * (end.y - start.y);
            out.z = displacement.startZ + start.z + gap.share * (end.z - start.z);
            placeContact(gap, out);
        }

        /** @inheritDoc */
        override public function findClosest(a:BoundingStructure, b:BoundingStructure, out:ClosestPoints):void
        {
            var capsule:Capsule = a as Capsule;
            var box:Box = b as Box;
            relate(capsule, box, RelativeMotion.NONE);
            rotateGap(box);
            var start:Vector3D = capsule.start;
            var end:Vector3D = capsule.end;
            out.aX = start.x + _gap.share * (end.x - start.x);
            out.aY = start.y + _gap.share * (end.y - start.y);
            out.aZ = start.z + _gap.share * (end.z - start.z);
            moveToSurfaces(_gap, out);
        }

        // Sets the way and the gap at time 0, and the radius.
        private function relate(capsule:Capsule, box:Box, motion:RelativeMotion):void
        {
            var way:RelativeMotion = _way;
            var segment:BoxSegment = _axis;
            var start:Vector3D = capsule.start;
            var end:Vector3D = capsule.end;
            var middle:Vector3D = box.center;
            var x:Number = start.x - middle.x;
            var y:Number = start.y - middle.y;
            var z:Number = start.z - middle.z;
            var toX:Number = end.x - start.x;
            var toY:Number = end.y - start.y;
            var toZ:Number = end.z - start.z;
            var axis:Vector3D = box.axisX;
            var along:Number = axis.x * toX + axis.y * toY + axis.z * toZ;
            var sign:Number = along < 0 ? -1 : 1;
            segment.alongX = sign * along;
            way.startX = segment.x = sign * (axis.x * x + axis.y * y + axis.z * z + (axis.x * motion.startX + axis.y * motion.startY + axis.z * motion.startZ));
            way.x = sign * (axis.x * motion.x + axis.y * motion.y + axis.z * motion.z);
            segment.signX = sign;
            axis = box.axisY;
            along = axis.x * toX + axis.y * toY + axis.z * toZ;
            sign = along < 0 ? -1 : 1;
            segment.alongY = sign * along;
            way.startY = segment.y = sign * (axis.x * x + axis.y * y + axis.z * z + (axis.x * motion.startX + axis.y * motion.startY + axis.z * motion.startZ));
            way.y = sign * (axis.x * motion.x + axis.y * motion.y + axis.z * motion.z);
            segment.signY = sign;
            axis = box.axisZ;
            along = axis.x * toX + axis.y * toY + axis.z * toZ;
            sign = along < 0 ? -1 : 1;
            segment.alongZ = sign * along;
            way.startZ = segment.z = sign * (axis.x * x + axis.y * y + axis.z * z + (axis.x * motion.startX + axis.y * motion.startY + axis.z * motion.startZ));
            way.z = sign * (axis.x * motion.x + axis.y * motion.y + axis.z * motion.z);
            segment.signZ = sign;
            segment.halfX = box.halfX;
            segment.halfY = box.halfY;
            segment.halfZ = box.halfZ;
            _gap.radiusA = capsule.radius;
            findBoxSegmentGap(segment, _gap);
        }

        // Finds the gap at the way's time, in the mirrored axes.
        private function findGap():void
        {
            var way:RelativeMotion = _way;
            var segment:BoxSegment = _axis;
            var time:Number = way.time;
            segment.x = way.startX + time * way.x;
            segment.y = way.startY + time * way.y;
            segment.z = way.startZ + time * way.z;
            findBoxSegmentGap(segment, _gap);
        }

        private function measure():void
        {
            var segment:BoxSegment = _axis;
            _gap.size = segment.alongX + segment.alongY + segment.alongZ + segment.halfX + segment.halfY + segment.halfZ + _gap.radiusA;
        }

        // Rotates the gap from the mirrored axes into those of the structures' space.
        private function rotateGap(box:Box):void
        {
            _gap.x *= _axis.signX;
            _gap.y *= _axis.signY;
            _gap.z *= _axis.signZ;
            rotateFromBox(box, _gap);
        }
    }
}
