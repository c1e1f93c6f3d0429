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

        // Four numbers for each half-space: x, y, z of the normal, and the depth. _end is the count of these numbers.
        private var _planes:Vector.<Number> = new Vector.<Number>();
        private var _end:int = 0;

        // How much less than required every displacement may go along a normal, and the displacement that is tried.
        private var _slack:Number = 0;
        private var _tried:Vector3D = new Vector3D();

        /** Begins without half-spaces. */
        public function clear():void
        {
            _end = 0;
            setToNone();
        }

        /** Adds a half-space: a unit normal, and the depth along it. */
        public function add(x:Number, y:Number, z:Number, depth:Number):void
        {
            _planes[_end] = x;
            _planes[int(_end + 1)] = y;
            _planes[int(_end + 2)] = z;
            _planes[int(_end + 3)] = depth;
            _end += 4;
        }

        /** Removes the half-spaces that the displacement leads out of farther than required: they did not decide about it. */
        public function keepDeciding():void
        {
            var planes:Vector.<Number> = _planes;
            var slack:Number = DECIDING_SLACK * displacement.length;
            var end:int = _end;
            _end = 0;
            for (var i:int = 0; i < end; i += 4)
            {
                if (displacement.x * planes[i] + displacement.y * planes[int(i + 1)] + displacement.z * planes[int(i + 2)] <= planes[int(i + 3)] + slack)
                {
                    add(planes[i], planes[int(i + 1)], planes[int(i + 2)], planes[int(i + 3)]);
                }
            }
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
            var planes:Vector.<Number> = _planes;
            _slack = slack;
            _tried.setTo(0, 0, 0);
            setToNone();
            if (leadsOut(0))
            {
                return true;
            }
            for (var i:int = 0; i < _end; i += 4)
            {
                // no displacement may be longer than this
                distance = Math.max(distance, MAX_LENGTH_RATIO * planes[int(i + 3)]);
            }
            for (i = 0; i < _end; i += 4)
            {
                var depth:Number = planes[int(i + 3)];
                // the shortest displacement does not end on the plane alone if it may go against the normal
                if (depth > 0)
                {
                    _tried.setTo(depth * planes[i], depth * planes[int(i + 1)], depth * planes[int(i + 2)]);
                    keepShorter(1);
                }
            }
            for (i = 4; i < _end && maxPlanes > 1; i += 4)
            {
                for (var j:int = 0; j < i; j += 4)
                {
                    tryLine(i, j, maxPlanes);
                }
            }
            distance = planeCount == 0 ? Infinity : distance;
            return planeCount > 0;
        }

        private function setToNone():void
        {
            displacement.setTo(0, 0, 0);
            distance = planeCount = 0;
        }

        // Tries the nearest point of the line in which two planes meet, then the points where this line meets planes before them. The sum and the
        // difference of two unit normals are perpendicular, so no digits are lost, even if the planes are nearly parallel. Planes are given by their
        // first numbers.
        private function tryLine(i:int, j:int, maxPlanes:int):void
        {
            var planes:Vector.<Number> = _planes;
            var sumX:Number = planes[i] + planes[j];
            var sumY:Number = planes[int(i + 1)] + planes[int(j + 1)];
            var sumZ:Number = planes[int(i + 2)] + planes[int(j + 2)];
            var differenceX:Number = planes[i] - planes[j];
            var differenceY:Number = planes[int(i + 1)] - planes[int(j + 1)];
            var differenceZ:Number = planes[int(i + 2)] - planes[int(j + 2)];
            var along:Number = (planes[int(i + 3)] + planes[int(j + 3)]) / (sumX * sumX + sumY * sumY + sumZ * sumZ);
            var across:Number = (planes[int(i + 3)] - planes[int(j + 3)]) / (differenceX * differenceX + differenceY * differenceY + differenceZ * differenceZ);
            var x:Number = along * sumX + across * differenceX;
            var y:Number = along * sumY + across * differenceY;
            var z:Number = along * sumZ + across * differenceZ;
            _tried.setTo(x, y, z);
            keepShorter(2);
            var lineX:Number = sumY * differenceZ - sumZ * differenceY;
            var lineY:Number = sumZ * differenceX - sumX * differenceZ;
            var lineZ:Number = sumX * differenceY - sumY * differenceX;
            for (var k:int = 0; k < j && maxPlanes > 2; k += 4)
            {
                var far:Number = (planes[int(k + 3)] - (x * planes[k] + y * planes[int(k + 1)] + z * planes[int(k + 2)]))
                    / (lineX * planes[k] + lineY * planes[int(k + 1)] + lineZ * planes[int(k + 2)]);
                _tried.setTo(x + far * lineX, y + far * lineY, z + far * lineZ);
                keepShorter(3);
            }
        }

        // Keeps the displacement that is tried if it is shorter and leads out of all half-spaces. Planes that do not meet make no numbers of it.
        private function keepShorter(planeCount:int):void
        {
            var length:Number = Math.sqrt(_tried.x * _tried.x + _tried.y * _tried.y + _tried.z * _tried.z);
            if (length < distance && leadsOut(length))
            {
                displacement.copyFrom(_tried);
                distance = length;
                this.planeCount = planeCount;
            }
        }

        private function leadsOut(length:Number):Boolean
        {
            var planes:Vector.<Number> = _planes;
            var slack:Number = _slack + RELATIVE_SLACK * length;
            for (var i:int = 0; i < _end; i += 4)
            {
                if (_tried.x * planes[i] + _tried.y * planes[int(i + 1)] + _tried.z * planes[int(i + 2)] < planes[int(i + 3)] - slack)
                {
                    return false;
                }
            }
            return true;
        }
    }
}
