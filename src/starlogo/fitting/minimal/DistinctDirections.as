package starlogo.fitting.minimal
{
    /**
     * A set of directions. Opposite directions are the same. If several directions are close together, only one of them is kept.
     *
     * @private
     */
    public final class DistinctDirections
    {
        private var _directions:Vector.<Number> = new Vector.<Number>();
        private var _cells:Object = {};
        private var _cellsPerUnit:Number;

        /**
         * @param spacing the approximate angle below which directions are close, in radians
         */
        public function DistinctDirections(spacing:Number)
        {
            _cellsPerUnit = 1 / spacing;
        }

        /** The directions kept: unit vectors, x, y, z of each. */
        public function get directions():Vector.<Number>
        {
            return _directions;
        }

        /** Keeps a direction, unless a close one was kept before. The vector may have any length but 0. */
        public function add(x:Number, y:Number, z:Number):void
        {
            var length:Number = Math.sqrt(x * x + y * y + z * z);
            if (z < 0 || z == 0 && (y < 0 || y == 0 && x < 0))
            {
                length = -length;
            }
            x /= length;
            y /= length;
            z /= length;
            var cell:String = Math.round(x * _cellsPerUnit) + "," + Math.round(y * _cellsPerUnit) + "," + Math.round(z * _cellsPerUnit);
            if (!(cell in _cells))
            {
                _cells[cell] = true;
                _directions.push(x, y, z);
            }
        }
    }
}
