package starlogo.intersection
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Capsule;
    import starlogo.geometry.Tolerances;
    import starlogo.intersection.contact.ContactPoint;
    import starlogo.intersection.distance.DistanceResult;
    import starlogo.intersection.sweep.RelativeMotion;

    /** The kernel of two capsules (Ericson, "Real-Time Collision Detection", §5.1.9). */
    internal final class CapsuleCapsuleKernel extends RoundPairKernel
    {
        private static const OVERLAP_KERNEL:BoxBoxKernel = new BoxBoxKernel();

        // The two segments, u and v.
        private var _ux:Number;
        private var _uy:Number;
        private var _uz:Number;
        private var _vx:Number;
        private var _vy:Number;
        private var _vz:Number;

        override protected function relate(a:BoundingStructure, b:BoundingStructure, motion:RelativeMotion):void
        {
            var capsule:Capsule = a as Capsule;
            var other:Capsule = b as Capsule;
            var startA:Vector3D = capsule.start;
            var startB:Vector3D = other.start;
            var end:Vector3D = capsule.end;
            fromX = startA.x - startB.x + motion.startX;
            fromY = startA.y - startB.y + motion.startY;
            fromZ = startA.z - startB.z + motion.startZ;
            motionX = motion.x;
            motionY = motion.y;
            motionZ = motion.z;
            radiusSum = capsule.radius + other.radius;
            _ux = end.x - startA.x;
            _uy = end.y - startA.y;
            _uz = end.z - startA.z;
            end = other.end;
            _vx = end.x - startB.x;
            _vy = end.y - startB.y;
            _vz = end.z - startB.z;
        }

        /**
         * Finds the closest points of two segments. It sets the gap, and the share of the first segment at which its closest point lies.
         *
         * @param a x, y, z of each end of the first segment
         * @param startA index of its start in a
         * @param endA index of its end in a
         * @param b x, y, z of each end of the second segment
         * @param startB index of its start in b
         * @param endB index of its end in b
         */
        public function findEdges(a:Vector.<Number>, startA:int, endA:int, b:Vector.<Number>, startB:int, endB:int):void
        {
            fromX = a[startA] - b[startB];
            fromY = a[int(startA + 1)] - b[int(startB + 1)];
            fromZ = a[int(startA + 2)] - b[int(startB + 2)];
            motionX = motionY = motionZ = 0;
            _ux = a[endA] - a[startA];
            _uy = a[int(endA + 1)] - a[int(startA + 1)];
            _uz = a[int(endA + 2)] - a[int(startA + 2)];
            _vx = b[endB] - b[startB];
            _vy = b[int(endB + 1)] - b[int(startB + 1)];
            _vz = b[int(endB + 2)] - b[int(startB + 2)];
            timeParameter = 0;
            find();
        }

        override protected function find():void
        {
            var time:Number = timeParameter;
            var x:Number = fromX + time * motionX;
            var y:Number = fromY + time * motionY;
            var z:Number = fromZ + time * motionZ;
            var ux:Number = _ux;
            var uy:Number = _uy;
            var uz:Number = _uz;
            var vx:Number = _vx;
            var vy:Number = _vy;
            var vz:Number = _vz;
            include "segmentToSegment.inc";
            share = s;
            gapX = x + s * ux - t * vx;
            gapY = y + s * uy - t * vy;
            gapZ = z + s * uz - t * vz;
        }

        /** @inheritDoc */
        override public function findClosest(a:BoundingStructure, b:BoundingStructure, out:DistanceResult):void
        {
            // The order is always the same, so that rounding is the same for (a, b) and (b, a).
            var capsuleA:Capsule = Capsule(a);
            var capsuleB:Capsule = Capsule(b);
            var startA:Vector3D = capsuleA.start;
            var startB:Vector3D = capsuleB.start;
            if (startA.x > startB.x || (startA.x == startB.x && isAfter(startA, startB)))
            {
                super.findClosest(b, a, out);
                out.swapShapes();
            }
            else
            {
                super.findClosest(a, b, out);
            }
        }

        override protected function measure():void
        {
            size = Math.sqrt(_ux * _ux + _uy * _uy + _uz * _uz) + Math.sqrt(_vx * _vx + _vy * _vy + _vz * _vz) + radiusSum;
        }

        // The normal is perpendicular to both segments, and points to the side of a's middle. If the segments are parallel, it points
        // upwards as far as possible.
        override protected function findOverlap(a:BoundingStructure, b:BoundingStructure, displacement:RelativeMotion, out:ContactPoint):void
        {
            OVERLAP_KERNEL.findNormal(a, b, displacement, out);
            out.depth = radiusSum;
            placeCapsule(a, displacement, out);
        }
    }
}
