package starlogo.intersection
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
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

    /** The kernel of two capsules. */
    internal final class CapsuleCapsuleKernel extends PairKernel
    {
        // The motion of the first axis's start as seen from the second's.
        private var _way:RelativeMotion = new RelativeMotion();
        private var _axes:SegmentPair = new SegmentPair();
        private var _gap:RoundGap = new RoundGap();
        private var _steps:NewtonSteps = new NewtonSteps();
        private var _overlap:LeastOverlap = new LeastOverlap();

        /** @inheritDoc */
        override public function findTime(a:BoundingStructure, b:BoundingStructure, motion:RelativeMotion):void
        {
            relate(a as Capsule, b as Capsule, motion);
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

        /**
         * If the axes cross, the normal is perpendicular to both, and points to the side of a's middle. If they are parallel too, it points
         * upwards as far as possible.
         *
         * @inheritDoc
         */
        override public function findContact(a:BoundingStructure, b:BoundingStructure, displacement:RelativeMotion, out:ContactPoint):void
        {
            var capsule:Capsule = a as Capsule;
            relate(capsule, b as Capsule, displacement);
            measure();
            var gap:RoundGap = _gap;
            var squared:Number = gap.x * gap.x + gap.y * gap.y + gap.z * gap.z;
            // If the gap is longer than this, it has a direction in spite of rounding.
            var least:Number = Tolerances.DIRECTION * gap.size;
            var depth:Number = gap.radiusA + gap.radiusB;
            if (squared > least * least)
            {
                var length:Number = Math.sqrt(squared);
                out.setNormal(gap.x / length, gap.y / length, gap.z / length);
                depth -= length;
            }
            else
            {
                _overlap.findNormal(a, b, displacement, out);
            }
            out.depth = depth;
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
            // The order is always the same, so that rounding is the same for (a, b) and (b, a).
            var capsule:Capsule = a as Capsule;
            var other:Capsule = b as Capsule;
            var start:Vector3D = capsule.start;
            var isSwapped:Boolean = start.x > other.start.x || (start.x == other.start.x && isAfter(start, other.start));
            if (isSwapped)
            {
                capsule = other;
                other = a as Capsule;
                start = capsule.start;
            }
            relate(capsule, other, RelativeMotion.NONE);
            var end:Vector3D = capsule.end;
            out.aX = start.x + _gap.share * (end.x - start.x);
            out.aY = start.y + _gap.share * (end.y - start.y);
            out.aZ = start.z + _gap.share * (end.z - start.z);
            moveToSurfaces(_gap, out);
            if (isSwapped)
            {
                out.swapShapes();
            }
        }

        // Sets the way and the gap at time 0, and the radii.
        private function relate(capsule:Capsule, other:Capsule, motion:RelativeMotion):void
        {
            var startA:Vector3D = capsule.start;
            var startB:Vector3D = other.start;
            var way:RelativeMotion = _way;
            var axes:SegmentPair = _axes;
            way.startX = axes.x = startA.x - startB.x + motion.startX;
            way.startY = axes.y = startA.y - startB.y + motion.startY;
            way.startZ = axes.z = startA.z - startB.z + motion.startZ;
            way.x = motion.x;
            way.y = motion.y;
            way.z = motion.z;
            var end:Vector3D = capsule.end;
            axes.ux = end.x - startA.x;
            axes.uy = end.y - startA.y;
            axes.uz = end.z - startA.z;
            end = other.end;
            axes.vx = end.x - startB.x;
            axes.vy = end.y - startB.y;
            axes.vz = end.z - startB.z;
            _gap.radiusA = capsule.radius;
            _gap.radiusB = other.radius;
            findSegmentGap(axes, _gap);
        }

        // Finds the gap at the way's time.
        private function findGap():void
        {
            var way:RelativeMotion = _way;
            var axes:SegmentPair = _axes;
            var time:Number = way.time;
            axes.x = way.startX + time * way.x;
            axes.y = way.startY + time * way.y;
            axes.z = way.startZ + time * way.z;
            findSegmentGap(axes, _gap);
        }

        private function measure():void
        {
            var axes:SegmentPair = _axes;
            _gap.size = Math.sqrt(axes.ux * axes.ux + axes.uy * axes.uy + axes.uz * axes.uz)
                + Math.sqrt(axes.vx * axes.vx + axes.vy * axes.vy + axes.vz * axes.vz) + (_gap.radiusA + _gap.radiusB);
        }
    }
}
