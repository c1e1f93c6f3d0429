package starlogo.intersection
{
    import flash.geom.Vector3D;
    import starlogo.bounding.Capsule;
    import starlogo.geometry.Tolerances;
    import starlogo.intersection.contact.ContactPoint;

    /**
     * The nearest points of two capsules' segments, for one capsule in many places (Ericson, "Real-Time Collision Detection",
     * §5.1.9). What does not depend on the place is computed once.
     */
    public final class SegmentPair
    {
        /** For tests that are over before the next begins. */
        public static const SCRATCH:SegmentPair = new SegmentPair();

        /** From the start of b's segment to that of a's, where the capsules stand. */
        public var x:Number;

        /** @copy #x */
        public var y:Number;

        /** @copy #x */
        public var z:Number;

        /** Where on a's segment the nearest point is, from 0 to 1. */
        public var s:Number;

        /** The same on b's. */
        public var t:Number;

        /** From the nearest point of b's segment to that of a's. */
        public var gapX:Number;

        /** @copy #gapX */
        public var gapY:Number;

        /** @copy #gapX */
        public var gapZ:Number;

        // The segments, u and v, their products and their cross product; for the latter's products of four lengths, over the product of
        // two powers of two near their lengths.
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
        private var _unit:Number;
        private var _denominator:Number;

        /** No segments yet. */
        public function SegmentPair()
        {
        }

        /** Takes the segments of two capsules. */
        public function relate(a:Capsule, b:Capsule):void
        {
            var startA:Vector3D = a.start;
            var startB:Vector3D = b.start;
            var end:Vector3D = a.end;
            x = startA.x - startB.x;
            y = startA.y - startB.y;
            z = startA.z - startB.z;
            var ux:Number = end.x - startA.x;
            var uy:Number = end.y - startA.y;
            var uz:Number = end.z - startA.z;
            end = b.end;
            var vx:Number = end.x - startB.x;
            var vy:Number = end.y - startB.y;
            var vz:Number = end.z - startB.z;
            var uu:Number = ux * ux + uy * uy + uz * uz;
            var vv:Number = vx * vx + vy * vy + vz * vz;
            var uv:Number = ux * vx + uy * vy + uz * vz;
            // Products of four lengths might overflow or vanish.
            var longest:Number = uu > vv ? uu : vv;
            _unit = longest > 1e140 || longest < 1e-140 && longest > 0 ? 1 / longest : 1;
            _denominator = uu * _unit * vv - uv * _unit * uv;
            _isNearlyParallel = _denominator <= Tolerances.NEARLY_PARALLEL * uu * _unit * vv;
            if (_isNearlyParallel)
            {
                _crossX = uy * vz - uz * vy;
                _crossY = uz * vx - ux * vz;
                _crossZ = ux * vy - uy * vx;
                _denominator = _crossX * _unit * _crossX + _crossY * _unit * _crossY + _crossZ * _unit * _crossZ;
            }
            _ux = ux;
            _uy = uy;
            _uz = uz;
            _vx = vx;
            _vy = vy;
            _vz = vz;
            _uu = uu;
            _vv = vv;
            _uv = uv;
        }

        /** The lengths of both segments together. */
        public function get lengths():Number
        {
            return Math.sqrt(_uu) + Math.sqrt(_vv);
        }

        /**
         * The normal where the segments cross: at right angles to both, as upright as can be where they are parallel, and to the side
         * where a's middle is.
         *
         * @param x how far a is displaced
         * @param y likewise
         * @param z likewise
         * @param out takes the normal
         */
        public function pointAcross(x:Number, y:Number, z:Number, out:ContactPoint):void
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
                out.pointAlong(crossX, crossY, crossZ);
            }
            else if (_uu > _vv)
            {
                out.pointAcross(_ux, _uy, _uz);
            }
            else
            {
                out.pointAcross(_vx, _vy, _vz);
            }
            x += this.x + (_ux - _vx) / 2;
            y += this.y + (_uy - _vy) / 2;
            z += this.z + (_uz - _vz) / 2;
            if (x * out.normalX + y * out.normalY + z * out.normalZ < 0)
            {
                out.pointAlong(-out.normalX, -out.normalY, -out.normalZ);
            }
        }

        /**
         * Finds the nearest points.
         *
         * @param x from the start of b's segment to that of a's
         * @param y likewise
         * @param z likewise
         */
        public function findNearest(x:Number, y:Number, z:Number):void
        {
            var ux:Number = _ux;
            var uy:Number = _uy;
            var uz:Number = _uz;
            var vx:Number = _vx;
            var vy:Number = _vy;
            var vz:Number = _vz;
            var uu:Number = _uu;
            var vv:Number = _vv;
            var uv:Number = _uv;
            var unit:Number = _unit;
            var alongU:Number = ux * x + uy * y + uz * z;
            var alongV:Number = vx * x + vy * y + vz * z;
            var numerator:Number;
            if (_isNearlyParallel)
            {
                // the same from cross products, which do not cancel
                numerator = (vy * z - vz * y) * unit * _crossX + (vz * x - vx * z) * unit * _crossY
                    + (vx * y - vy * x) * unit * _crossZ;
            }
            else
            {
                numerator = uv * unit * alongV - vv * unit * alongU;
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
            s = onA;
            t = onB;
            gapX = x + onA * ux - onB * vx;
            gapY = y + onA * uy - onB * vy;
            gapZ = z + onA * uz - onB * vz;
        }
    }
}
