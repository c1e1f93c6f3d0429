package starlogo.intersection
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Capsule;
    import starlogo.convex.CoreGap;
    import starlogo.convex.RelativeMotion;
    import starlogo.geometry.Tolerances;

    /** Finds the gap between the axes of two capsules. */
    internal final class CapsuleCapsuleGapFinder extends GapFinder
    {
        /** For <code>capsuleCapsule()</code>. */
        public static const STANDING:CapsuleCapsuleGapFinder = new CapsuleCapsuleGapFinder();

        // The axis of a, u, and that of b, v, each from its start to its end. The vector from v's start to u's.
        private var _uX:Number = 0;
        private var _uY:Number = 0;
        private var _uZ:Number = 0;
        private var _vX:Number = 0;
        private var _vY:Number = 0;
        private var _vZ:Number = 0;
        private var _x:Number = 0;
        private var _y:Number = 0;
        private var _z:Number = 0;

        // Where the closest points are on u and on v: from 0 at the start to 1 at the end.
        private var _shareOfU:Number = 0;
        private var _shareOfV:Number = 0;

        /** See capsuleCapsule. */
        override public function areTouching(a:BoundingStructure, b:BoundingStructure):Boolean
        {
            var capsuleA:Capsule = a as Capsule;
            var capsuleB:Capsule = b as Capsule;
            var isSwapped:Boolean = areSwapped(capsuleA, capsuleB);
            setAxes(isSwapped ? capsuleB : capsuleA, isSwapped ? capsuleA : capsuleB);
            findShares();
            var x:Number = _x + _shareOfU * _uX - _shareOfV * _vX;
            var y:Number = _y + _shareOfU * _uY - _shareOfV * _vY;
            var z:Number = _z + _shareOfU * _uZ - _shareOfV * _vZ;
            var touchingDistance:Number = (capsuleA.radius + capsuleB.radius) * Tolerances.TOUCHING;
            return x * x + y * y + z * z <= touchingDistance * touchingDistance;
        }

        /** @inheritDoc */
        override public function areSwapped(a:BoundingStructure, b:BoundingStructure):Boolean
        {
            var startA:Vector3D = (a as Capsule).start;
            var startB:Vector3D = (b as Capsule).start;
            // Capsules with the same start touch, so their order does not matter.
            return isAfter(startA, startB);
        }

        /** @inheritDoc */
        override public function find(a:BoundingStructure, b:BoundingStructure, motion:RelativeMotion, out:CoreGap):void
        {
            var capsuleA:Capsule = a as Capsule;
            var capsuleB:Capsule = b as Capsule;
            var start:Vector3D = capsuleA.start;
            var time:Number = motion.time;
            setAxes(capsuleA, capsuleB);
            _x = _x + motion.startX + time * motion.x;
            _y = _y + motion.startY + time * motion.y;
            _z = _z + motion.startZ + time * motion.z;
            findShares();
            out.x = _x + _shareOfU * _uX - _shareOfV * _vX;
            out.y = _y + _shareOfU * _uY - _shareOfV * _vY;
            out.z = _z + _shareOfU * _uZ - _shareOfV * _vZ;
            out.measure(motion);
            out.pointX = motion.startX + time * motion.x + (start.x + _shareOfU * _uX);
            out.pointY = motion.startY + time * motion.y + (start.y + _shareOfU * _uY);
            out.pointZ = motion.startZ + time * motion.z + (start.z + _shareOfU * _uZ);
            out.radiusA = capsuleA.radius;
            out.radiusB = capsuleB.radius;
            out.extent = Math.abs(_uX) + Math.abs(_uY) + Math.abs(_uZ) + (Math.abs(_vX) + Math.abs(_vY) + Math.abs(_vZ)) + (capsuleA.radius + capsuleB.radius);
        }

        private function setAxes(a:Capsule, b:Capsule):void
        {
            var startA:Vector3D = a.start;
            var startB:Vector3D = b.start;
            var end:Vector3D = a.end;
            _uX = end.x - startA.x;
            _uY = end.y - startA.y;
            _uZ = end.z - startA.z;
            end = b.end;
            _vX = end.x - startB.x;
            _vY = end.y - startB.y;
            _vZ = end.z - startB.z;
            _x = startA.x - startB.x;
            _y = startA.y - startB.y;
            _z = startA.z - startB.z;
        }

        // Finds the shares (Ericson, "Real-Time Collision Detection", §5.1.9). The squared distance is smallest where both its derivatives are 0:
        // uu * s - uv * t + alongU = 0 and uv * s - vv * t + alongV = 0. After one share is clamped, the other is computed again.
        private function findShares():void
        {
            var x:Number = _x;
            var y:Number = _y;
            var z:Number = _z;
            var ux:Number = _uX;
            var uy:Number = _uY;
            var uz:Number = _uZ;
            var vx:Number = _vX;
            var vy:Number = _vY;
            var vz:Number = _vZ;
            var uu:Number = ux * ux + uy * uy + uz * uz;
            var vv:Number = vx * vx + vy * vy + vz * vz;
            var uv:Number = ux * vx + uy * vy + uz * vz;
            var alongU:Number = ux * x + uy * y + uz * z;
            var alongV:Number = vx * x + vy * y + vz * z;
            var numerator:Number = uv * alongV - vv * alongU;
            var denominator:Number = uu * vv - uv * uv;
            if (denominator <= Tolerances.NEARLY_PARALLEL * uu * vv)
            {
                // The same values from cross products, which do not cancel.
                var crossX:Number = uy * vz - uz * vy;
                var crossY:Number = uz * vx - ux * vz;
                var crossZ:Number = ux * vy - uy * vx;
                numerator = (vy * z - vz * y) * crossX + (vz * x - vx * z) * crossY + (vx * y - vy * x) * crossZ;
                denominator = crossX * crossX + crossY * crossY + crossZ * crossZ;
            }
            var s:Number = numerator <= 0 ? 0 : (numerator >= denominator ? 1 : numerator / denominator);
            var t:Number = uv * s + alongV;
            if (t <= 0)
            {
                t = 0;
                s = alongU >= 0 ? 0 : (-alongU >= uu ? 1 : -alongU / uu);
            }
            else if (t >= vv)
            {
                t = 1;
                s = uv - alongU;
                s = s <= 0 ? 0 : (s >= uu ? 1 : s / uu);
            }
            else
            {
                t /= vv;
            }
            _shareOfU = s;
            _shareOfV = t;
        }
    }
}
