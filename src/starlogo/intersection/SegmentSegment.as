package starlogo.intersection
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Capsule;
    import starlogo.geometry.Tolerances;
    import starlogo.intersection.contact.ContactPoint;
    import starlogo.intersection.distance.ClosestPair;
    import starlogo.intersection.sweep.RelativeMotion;

    /** The kernel of two capsules (Ericson, "Real-Time Collision Detection", §5.1.9). */
    internal final class SegmentSegment extends ClosestPoints
    {
        // The segments, u and v, their products and their cross product.
        private var _ux:Number;
        private var _uy:Number;
        private var _uz:Number;
        private var _vx:Number;
        private var _vy:Number;
        private var _vz:Number;
        private var _uu:Number;
        private var _vv:Number;
        private var _uv:Number;
        private var _isNearlyParallel:Boolean;
        private var _crossX:Number;
        private var _crossY:Number;
        private var _crossZ:Number;
        private var _denominator:Number;

        /** Nothing related yet. */
        public function SegmentSegment()
        {
        }

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
            radii = capsule.radius + other.radius;
            _ux = end.x - startA.x;
            _uy = end.y - startA.y;
            _uz = end.z - startA.z;
            end = other.end;
            _vx = end.x - startB.x;
            _vy = end.y - startB.y;
            _vz = end.z - startB.z;
            multiply();
        }

        /**
         * Finds the closest points of two segments: the gap, and where on the first its point is.
         *
         * @param a has the ends of the first, x, y, z each
         * @param startA where in a one end begins
         * @param endA where the other does
         * @param b has the ends of the second
         * @param startB where in b one end begins
         * @param endB where the other does
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
            multiply();
            moment = 0;
            find();
        }

        private function multiply():void
        {
            var ux:Number = _ux;
            var uy:Number = _uy;
            var uz:Number = _uz;
            var vx:Number = _vx;
            var vy:Number = _vy;
            var vz:Number = _vz;
            var uu:Number = ux * ux + uy * uy + uz * uz;
            var vv:Number = vx * vx + vy * vy + vz * vz;
            var uv:Number = ux * vx + uy * vy + uz * vz;
            _denominator = uu * vv - uv * uv;
            _isNearlyParallel = _denominator <= Tolerances.NEARLY_PARALLEL * uu * vv;
            if (_isNearlyParallel)
            {
                _crossX = uy * vz - uz * vy;
                _crossY = uz * vx - ux * vz;
                _crossZ = ux * vy - uy * vx;
                _denominator = _crossX * _crossX + _crossY * _crossY + _crossZ * _crossZ;
            }
            _uu = uu;
            _vv = vv;
            _uv = uv;
        }

        override protected function find():void
        {
            var time:Number = moment;
            var x:Number = fromX + time * motionX;
            var y:Number = fromY + time * motionY;
            var z:Number = fromZ + time * motionZ;
            var ux:Number = _ux;
            var uy:Number = _uy;
            var uz:Number = _uz;
            var vx:Number = _vx;
            var vy:Number = _vy;
            var vz:Number = _vz;
            var uu:Number = _uu;
            var vv:Number = _vv;
            var uv:Number = _uv;
            var alongU:Number = ux * x + uy * y + uz * z;
            var alongV:Number = vx * x + vy * y + vz * z;
            var numerator:Number;
            if (_isNearlyParallel)
            {
                // the same from cross products, which do not cancel
                numerator = (vy * z - vz * y) * _crossX + (vz * x - vx * z) * _crossY + (vx * y - vy * x) * _crossZ;
            }
            else
            {
                numerator = uv * alongV - vv * alongU;
            }
            var onA:Number = numerator <= 0 ? 0 : (numerator >= _denominator ? 1 : numerator / _denominator);
            var onB:Number = uv * onA + alongV;
            if (onB <= 0)
            {
                onB = 0;
                onA = alongU >= 0 ? 0 : (-alongU >= uu ? 1 : -alongU / uu);
            }
            else if (onB >= vv)
            {
                onB = 1;
                onA = uv - alongU;
                onA = onA <= 0 ? 0 : (onA >= uu ? 1 : onA / uu);
            }
            else
            {
                onB /= vv;
            }
            share = onA;
            gapX = x + onA * ux - onB * vx;
            gapY = y + onA * uy - onB * vy;
            gapZ = z + onA * uz - onB * vz;
        }

        /** @inheritDoc */
        override public function findClosest(a:BoundingStructure, b:BoundingStructure, out:ClosestPair):void
        {
            // always in one order: then rounding is the same in either
            var startA:Vector3D = Capsule(a).start;
            var startB:Vector3D = Capsule(b).start;
            if (startA.x > startB.x || (startA.x == startB.x && isAfter(startA, startB)))
            {
                super.findClosest(b, a, out);
                out.turn();
            }
            else
            {
                super.findClosest(a, b, out);
            }
        }

        override protected function measure():void
        {
            size = Math.sqrt(_uu) + Math.sqrt(_vv) + radii;
        }

        // At right angles to both segments, as upright as can be where they are parallel, and to the side where a's middle is.
        override protected function findOverlap(a:BoundingStructure, b:BoundingStructure, displacement:RelativeMotion, out:ContactPoint):void
        {
            var unit:Number = 1 / Math.sqrt(_uu > _vv ? _uu : _vv);
            var ux:Number = _ux * unit;
            var uy:Number = _uy * unit;
            var uz:Number = _uz * unit;
            var vx:Number = _vx * unit;
            var vy:Number = _vy * unit;
            var vz:Number = _vz * unit;
            var crossX:Number = uy * vz - uz * vy;
            var crossY:Number = uz * vx - ux * vz;
            var crossZ:Number = ux * vy - uy * vx;
            var sine:Number = crossX * crossX + crossY * crossY + crossZ * crossZ;
            var most:Number = (ux * ux + uy * uy + uz * uz) * (vx * vx + vy * vy + vz * vz);
            if (sine > Tolerances.DIRECTION * Tolerances.DIRECTION * most)
            {
                out.setNormal(crossX, crossY, crossZ);
                out.normalise();
            }
            else if (_uu > _vv)
            {
                out.setNormal(_ux, _uy, _uz);
                out.pointAcross();
            }
            else
            {
                out.setNormal(_vx, _vy, _vz);
                out.pointAcross();
            }
            var startA:Vector3D = Capsule(a).start;
            var startB:Vector3D = Capsule(b).start;
            var x:Number = displacement.startX + (startA.x - startB.x + (_ux - _vx) / 2);
            var y:Number = displacement.startY + (startA.y - startB.y + (_uy - _vy) / 2);
            var z:Number = displacement.startZ + (startA.z - startB.z + (_uz - _vz) / 2);
            if (x * out.normalX + y * out.normalY + z * out.normalZ < 0)
            {
                out.setNormal(-out.normalX, -out.normalY, -out.normalZ);
                out.normalise();
            }
            out.depth = radii;
            placeContact(a, displacement, out);
        }
    }
}
