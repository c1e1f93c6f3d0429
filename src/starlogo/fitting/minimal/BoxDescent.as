package starlogo.fitting.minimal
{
    import starlogo.geometry.ConvexHull;

    /**
     * Descends from a direction to a box that no small change makes smaller. It is a part of MinimalBoxFitter.
     *
     * <p>A box's volume is a function of the direction of its side. This function has creases along the arcs of directions perpendicular
     * to an edge of the hull. Its minimum is on a crease, or where two creases meet. So the descent tries steps to all sides. It also
     * tries steps onto and along some creases: the creases of the edges at the two corners that touch the box. It also tries the
     * directions of the box's other sides, because the volume depends on these in the same way.</p>
     *
     * @private
     */
    public final class BoxDescent extends DirectionSearch
    {
        private static const FIRST_STEP:Number = 0.05;
        private static const LAST_STEP:Number = 1e-10;
        private static const SHRINK:Number = 0.4;
        // If the relative gain is below this share of the step, no further step of that length is tried.
        private static const GAIN:Number = 1e-3;

        /** The axes of the smallest box so far: three unit vectors, nine numbers. */
        public var axes:Vector.<Number>;

        private var _hull:ConvexHull;
        private var _box:BoxAlongAxis;
        private var _leastMeasured:Number = Infinity;
        private var _least:Number = Infinity;

        // The current box: its volume, its direction, one side, and the two corners that touch it along the direction.
        private var _volume:Number;
        private var _x:Number;
        private var _y:Number;
        private var _z:Number;
        private var _sideX:Number;
        private var _sideY:Number;
        private var _sideZ:Number;
        private var _highest:int;
        private var _lowest:int;

        /**
         * @param hull the hull of the vertices
         */
        public function BoxDescent(hull:ConvexHull)
        {
            _hull = hull;
            _box = new BoxAlongAxis(hull);
        }

        override protected function measure(x:Number, y:Number, z:Number):Number
        {
            var volume:Number = _box.measure(x, y, z, 2 * _leastMeasured);
            _leastMeasured = Math.min(_leastMeasured, volume);
            return volume;
        }

        override protected function descendFrom(x:Number, y:Number, z:Number):void
        {
            _volume = Infinity;
            tryDirection(x, y, z);
            var step:Number = FIRST_STEP;
            while (step > LAST_STEP)
            {
                var before:Number = _volume;
                slideAt(_highest, step);
                slideAt(_lowest, step);
                stepAside(step);
                tryOtherSides();
                if (!(before - _volume > GAIN * step * before))
                {
                    step *= SHRINK;
                }
            }
            if (_volume < _least)
            {
                _least = _volume;
                axes = axesOfBox();
            }
        }

        private function tryDirection(x:Number, y:Number, z:Number):void
        {
            var length:Number = Math.sqrt(x * x + y * y + z * z);
            x /= length;
            y /= length;
            z /= length;
            var measured:Number = _box.measure(x, y, z, _volume);
            if (!(measured < _volume))
            {
                return;
            }
            _volume = measured;
            _x = x;
            _y = y;
            _z = z;
            _sideX = _box.sideX;
            _sideY = _box.sideY;
            _sideZ = _box.sideZ;
            _highest = _box.highest;
            _lowest = _box.lowest;
        }

        // Tries the crease of each edge at the corner, if it is within a step. From there, tries a step along it in both directions.
        private function slideAt(corner:int, step:Number):void
        {
            var points:Vector.<Number> = _hull.convexPoints;
            var end:int = _hull.firstNeighbor[corner + 1];
            for (var i:int = _hull.firstNeighbor[corner]; i < end; i++)
            {
                var other:int = _hull.neighbors[i];
                var edgeX:Number = points[3 * other] - points[3 * corner];
                var edgeY:Number = points[3 * other + 1] - points[3 * corner + 1];
                var edgeZ:Number = points[3 * other + 2] - points[3 * corner + 2];
                var length:Number = Math.sqrt(edgeX * edgeX + edgeY * edgeY + edgeZ * edgeZ);
                edgeX /= length;
                edgeY /= length;
                edgeZ /= length;
                var off:Number = _x * edgeX + _y * edgeY + _z * edgeZ;
                if (off > step || off < -step)
                {
                    continue;
                }
                var x:Number = _x - off * edgeX;
                var y:Number = _y - off * edgeY;
                var z:Number = _z - off * edgeZ;
                var alongX:Number = (edgeY * z - edgeZ * y) * step;
                var alongY:Number = (edgeZ * x - edgeX * z) * step;
                var alongZ:Number = (edgeX * y - edgeY * x) * step;
                tryDirection(x, y, z);
                tryDirection(x + alongX, y + alongY, z + alongZ);
                tryDirection(x - alongX, y - alongY, z - alongZ);
            }
        }

        private function stepAside(step:Number):void
        {
            var box:Vector.<Number> = axesOfBox();
            for (var i:int = 3; i < 9; i += 3)
            {
                tryDirection(box[0] + step * box[i], box[1] + step * box[i + 1], box[2] + step * box[i + 2]);
                tryDirection(box[0] - step * box[i], box[1] - step * box[i + 1], box[2] - step * box[i + 2]);
            }
        }

        private function tryOtherSides():void
        {
            var box:Vector.<Number> = axesOfBox();
            tryDirection(box[3], box[4], box[5]);
            tryDirection(box[6], box[7], box[8]);
        }

        private function axesOfBox():Vector.<Number>
        {
            return new <Number>[_x, _y, _z, _sideX, _sideY, _sideZ, _y * _sideZ - _z * _sideY, _z * _sideX - _x * _sideZ,
                    _x * _sideY - _y * _sideX];
        }
    }
}
