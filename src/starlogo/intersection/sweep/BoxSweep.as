package starlogo.intersection.sweep
{
    import starlogo.geometry.Tolerances;

    /**
     * When boxes that pass each other touch: separating axes over time. While no axis separates them they touch, and each axis
     * gives an interval of time; they first touch when the last interval begins, if that is before the first ends.
     *
     * <p>All is in the axes of the one box, a. For many pairs of boxes that are turned alike and move alike, what they have in
     * common is prepared once.</p>
     *
     * @private
     */
    public final class BoxSweep
    {
        /** For tests that are over before the next begins. */
        internal static const SCRATCH:BoxSweep = new BoxSweep();

        // Entry by entry, b's axes in a's: the first is of b's axisX along a's axisX, the next of b's axisY along a's axisX.
        private var _xx:Number;
        private var _xy:Number;
        private var _xz:Number;
        private var _yx:Number;
        private var _yy:Number;
        private var _yz:Number;
        private var _zx:Number;
        private var _zy:Number;
        private var _zz:Number;

        // b's motion from a's, in a's axes and in b's.
        private var _motionX:Number;
        private var _motionY:Number;
        private var _motionZ:Number;
        private var _motionAlongX:Number;
        private var _motionAlongY:Number;
        private var _motionAlongZ:Number;

        private var _times:TouchingTimes = new TouchingTimes();

        /** Nothing prepared yet. */
        public function BoxSweep()
        {
        }

        /** Sets b's axes in a's: row by row, unit vectors. */
        public function turn(xx:Number, xy:Number, xz:Number, yx:Number, yy:Number, yz:Number, zx:Number, zy:Number, zz:Number):void
        {
            _xx = xx;
            _xy = xy;
            _xz = xz;
            _yx = yx;
            _yy = yy;
            _yz = yz;
            _zx = zx;
            _zy = zy;
            _zz = zz;
        }

        /** Sets b's motion from a's between times 0 and 1, in a's axes. */
        public function move(x:Number, y:Number, z:Number):void
        {
            _motionX = x;
            _motionY = y;
            _motionZ = z;
            _motionAlongX = _xx * x + _yx * y + _zx * z;
            _motionAlongY = _xy * x + _yy * y + _zy * z;
            _motionAlongZ = _xz * x + _yz * y + _zz * z;
        }

        /**
         * When two boxes begin not to be separated by any face.
         *
         * @param x from a's middle to b's at time 0, in a's axes
         * @param y likewise
         * @param z likewise
         * @param aX a's half-extents
         * @param aY likewise
         * @param aZ likewise
         * @param bX b's half-extents
         * @param bY likewise
         * @param bZ likewise
         * @param gap across which they still touch
         * @param latest the latest time that is of interest
         * @return not after the boxes touch; RelativeMotion.NEVER if that is not until the latest time
         */
        public function facesMeet(x:Number, y:Number, z:Number, aX:Number, aY:Number, aZ:Number, bX:Number, bY:Number, bZ:Number,
                gap:Number, latest:Number):Number
        {
            var times:TouchingTimes = _times;
            times.reset(latest);
            var xx:Number = _xx < 0 ? -_xx : _xx;
            var xy:Number = _xy < 0 ? -_xy : _xy;
            var xz:Number = _xz < 0 ? -_xz : _xz;
            if (times.areSeparated(x, _motionX, aX + bX * xx + bY * xy + bZ * xz, gap))
            {
                return RelativeMotion.NEVER;
            }
            var yx:Number = _yx < 0 ? -_yx : _yx;
            var yy:Number = _yy < 0 ? -_yy : _yy;
            var yz:Number = _yz < 0 ? -_yz : _yz;
            if (times.areSeparated(y, _motionY, aY + bX * yx + bY * yy + bZ * yz, gap))
            {
                return RelativeMotion.NEVER;
            }
            var zx:Number = _zx < 0 ? -_zx : _zx;
            var zy:Number = _zy < 0 ? -_zy : _zy;
            var zz:Number = _zz < 0 ? -_zz : _zz;
            if (times.areSeparated(z, _motionZ, aZ + bX * zx + bY * zy + bZ * zz, gap))
            {
                return RelativeMotion.NEVER;
            }
            if (times.areSeparated(x * _xx + y * _yx + z * _zx, _motionAlongX,
                        bX + aX * xx + aY * yx + aZ * zx, gap))
            {
                return RelativeMotion.NEVER;
            }
            if (times.areSeparated(x * _xy + y * _yy + z * _zy, _motionAlongY,
                        bY + aX * xy + aY * yy + aZ * zy, gap))
            {
                return RelativeMotion.NEVER;
            }
            if (times.areSeparated(x * _xz + y * _yz + z * _zz, _motionAlongZ,
                        bZ + aX * xz + aY * yz + aZ * zz, gap))
            {
                return RelativeMotion.NEVER;
            }
            return times.first;
        }

        /**
         * When the same two boxes touch; after facesMeet, with the same arguments.
         *
         * <p>The cross products of an edge of each are projected on in full: however short one is because the edges are nearly parallel,
         * it is an axis like any other, and no identity between axes has to hold for more digits than it does.</p>
         */
        public function edgesMeet(x:Number, y:Number, z:Number, aX:Number, aY:Number, aZ:Number, bX:Number, bY:Number, bZ:Number,
                gap:Number):Number
        {
            var isSeparated:Boolean = isSeparatedAcross(x, y, z, aX, aY, aZ, _xx, _yx, _zx,
                    bY * _xy, bY * _yy, bY * _zy, bZ * _xz, bZ * _yz, bZ * _zz, gap)
                || isSeparatedAcross(x, y, z, aX, aY, aZ, _xy, _yy, _zy,
                    bZ * _xz, bZ * _yz, bZ * _zz, bX * _xx, bX * _yx, bX * _zx, gap)
                || isSeparatedAcross(x, y, z, aX, aY, aZ, _xz, _yz, _zz,
                    bX * _xx, bX * _yx, bX * _zx, bY * _xy, bY * _yy, bY * _zy, gap);
            return isSeparated ? RelativeMotion.NEVER : _times.first;
        }

        // Whether the cross product of edge p of b and one of a's separates all the time; q and r are b's other edges, half of each.
        private function isSeparatedAcross(x:Number, y:Number, z:Number, aX:Number, aY:Number, aZ:Number,
                pX:Number, pY:Number, pZ:Number, qX:Number, qY:Number, qZ:Number, rX:Number, rY:Number, rZ:Number, gap:Number):Boolean
        {
            var times:TouchingTimes = _times;
            var sizeX:Number = pX < 0 ? -pX : pX;
            var sizeY:Number = pY < 0 ? -pY : pY;
            var sizeZ:Number = pZ < 0 ? -pZ : pZ;
            var q:Number = qZ * pY - qY * pZ;
            q = q < 0 ? -q : q;
            var r:Number = rZ * pY - rY * pZ;
            r = r < 0 ? -r : r;
            if (sizeY + sizeZ > SHORTEST
                    && times.areSeparated(z * pY - y * pZ, _motionZ * pY - _motionY * pZ,
                        aY * sizeZ + aZ * sizeY + q + r, gap * (sizeY + sizeZ)))
            {
                return true;
            }
            q = qX * pZ - qZ * pX;
            q = q < 0 ? -q : q;
            r = rX * pZ - rZ * pX;
            r = r < 0 ? -r : r;
            if (sizeX + sizeZ > SHORTEST
                    && times.areSeparated(x * pZ - z * pX, _motionX * pZ - _motionZ * pX,
                        aZ * sizeX + aX * sizeZ + q + r, gap * (sizeX + sizeZ)))
            {
                return true;
            }
            q = qY * pX - qX * pY;
            q = q < 0 ? -q : q;
            r = rY * pX - rX * pY;
            r = r < 0 ? -r : r;
            return sizeX + sizeY > SHORTEST
                && times.areSeparated(y * pX - x * pY, _motionY * pX - _motionX * pY,
                    aX * sizeY + aY * sizeX + q + r, gap * (sizeX + sizeY));
        }

        // The length below which a cross product is rounding: the edges are parallel (Tolerances.PARALLEL).
        private static const SHORTEST:Number = Math.sqrt(Tolerances.PARALLEL);
    }
}
