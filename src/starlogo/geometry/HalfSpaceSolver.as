package starlogo.geometry
{
    import flash.geom.Vector3D;

    /**
     * Finds the shortest displacement of a point out of half-spaces: a quadratic program. A half-space requires that it goes at least a depth along its
     * normal. If the depth is less than 0, it may go so far against the normal.
     *
     * <p>The shortest displacement ends on the planes of no half-space, or of one, two or three of them (the active set). It tries all of these. This
     * takes few steps, because a body touches few surfaces at once.</p>
     *
     * @private
     */
    public final class HalfSpaceSolver
    {
        // How many times as long as the largest depth a displacement may be. Planes that are nearly opposite meet farther away.
        private static const MAX_LENGTH_RATIO:Number = 1000;

        // How much less than required a displacement may go along a normal, as a fraction of its length, because of rounding.
        private static const RELATIVE_SLACK:Number = 1e-12;

        // A half-space decides about a displacement if this goes at most so much farther than required along its normal, as a fraction of its length.
        private static const DECIDING_SLACK:Number = 1e-9;

        /** The shortest displacement, and none as long as there are no half-spaces. Read only. */
        public var displacement:Vector3D = new Vector3D();

        /** Its length; Infinity if no displacement leads out. Read only. */
        public var distance:Number = 0;

        /** On how many planes the displacement ends: the half-spaces of these decide. Read only. */
        public var planeCount:int = 0;

        // The number of half-spaces, and of each the normal and the depth.
        private var _count:int = 0;
        private var _xs:Vector.<Number> = new Vector.<Number>();
        private var _ys:Vector.<Number> = new Vector.<Number>();
        private var _zs:Vector.<Number> = new Vector.<Number>();
        private var _depths:Vector.<Number> = new Vector.<Number>();

        // How much less than required every displacement may go along a normal, how long it may be, and the one that is tried.
        private var _slack:Number = 0;
        private var _longest:Number = 0;
        private var _tried:Vector3D = new Vector3D();

        /** Begins without half-spaces. */
        public function clear():void
        {
            _count = 0;
            setToNone();
        }

        /** Adds a half-space: a unit normal, and the depth along it. */
        public function add(x:Number, y:Number, z:Number, depth:Number):void
        {
            _xs[_count] = x;
            _ys[_count] = y;
            _zs[_count] = z;
            _depths[_count] = depth;
            _count++;
        }

        /** Removes the half-spaces that the displacement leads out of farther than required: they did not decide about it. */
        public function keepDeciding():void
        {
            var slack:Number = DECIDING_SLACK * displacement.length;
            var kept:int = 0;
            for (var i:int = 0; i < _count; i++)
            {
                if (displacement.x * _xs[i] + displacement.y * _ys[i] + displacement.z * _zs[i] <= _depths[i] + slack)
                {
                    _xs[kept] = _xs[i];
                    _ys[kept] = _ys[i];
                    _zs[kept] = _zs[i];
                    _depths[kept] = _depths[i];
                    kept++;
                }
            }
            _count = kept;
        }

        /**
         * Finds the shortest displacement.
         *
         * @param maxPlanes on how many planes it may end, from 1 to 3
         * @param slack how much less than required it may go along each normal
         * @return whether there is one
         */
        public function solve(maxPlanes:int = 3, slack:Number = 0):Boolean
        {
            _slack = slack;
            _tried.setTo(0, 0, 0);
            setToNone();
            if (leadsOut(0))
            {
                return true;
            }
            distance = Infinity;
            _longest = 0;
            for (var i:int = 0; i < _count; i++)
            {
                _longest = Math.max(_longest, MAX_LENGTH_RATIO * _depths[i]);
                _tried.setTo(_depths[i] * _xs[i], _depths[i] * _ys[i], _depths[i] * _zs[i]);
                keepShorter(1);
            }
            for (i = 1; i < _count && maxPlanes > 1; i++)
            {
                for (var j:int = 0; j < i; j++)
                {
                    tryLine(i, j, maxPlanes);
                }
            }
            return distance < Infinity;
        }

        private function setToNone():void
        {
            displacement.setTo(0, 0, 0);
            distance = planeCount = 0;
        }

        // Tries the nearest point of the line in which two planes meet, then the points where this line meets planes before them. The sum and the
        // difference of two unit normals are perpendicular, so no digits are lost, even if the planes are nearly parallel.
        private function tryLine(i:int, j:int, maxPlanes:int):void
        {
            var sumX:Number = _xs[i] + _xs[j];
            var sumY:Number = _ys[i] + _ys[j];
            var sumZ:Number = _zs[i] + _zs[j];
            var differenceX:Number = _xs[i] - _xs[j];
            var differenceY:Number = _ys[i] - _ys[j];
            var differenceZ:Number = _zs[i] - _zs[j];
            var along:Number = (_depths[i] + _depths[j]) / (sumX * sumX + sumY * sumY + sumZ * sumZ);
            var across:Number = (_depths[i] - _depths[j]) / (differenceX * differenceX + differenceY * differenceY + differenceZ * differenceZ);
            var x:Number = along * sumX + across * differenceX;
            var y:Number = along * sumY + across * differenceY;
            var z:Number = along * sumZ + across * differenceZ;
            _tried.setTo(x, y, z);
            keepShorter(2);
            var lineX:Number = sumY * differenceZ - sumZ * differenceY;
            var lineY:Number = sumZ * differenceX - sumX * differenceZ;
            var lineZ:Number = sumX * differenceY - sumY * differenceX;
            for (var k:int = 0; k < j && maxPlanes > 2; k++)
            {
                var far:Number = (_depths[k] - (x * _xs[k] + y * _ys[k] + z * _zs[k])) / (lineX * _xs[k] + lineY * _ys[k] + lineZ * _zs[k]);
                _tried.setTo(x + far * lineX, y + far * lineY, z + far * lineZ);
                keepShorter(3);
            }
        }

        // Keeps the displacement that is tried if it is shorter and leads out of all half-spaces. Planes that do not meet make no numbers of it.
        private function keepShorter(planeCount:int):void
        {
            var length:Number = Math.sqrt(_tried.x * _tried.x + _tried.y * _tried.y + _tried.z * _tried.z);
            if (length < distance && length <= _longest && leadsOut(length))
            {
                displacement.copyFrom(_tried);
                distance = length;
                this.planeCount = planeCount;
            }
        }

        private function leadsOut(length:Number):Boolean
        {
            var slack:Number = _slack + RELATIVE_SLACK * length;
            for (var i:int = 0; i < _count; i++)
            {
                if (_tried.x * _xs[i] + _tried.y * _ys[i] + _tried.z * _zs[i] < _depths[i] - slack)
                {
                    return false;
                }
            }
            return true;
        }
    }
}
