package starlogo.geometry
{
    import starlogo.steps.Steps;

    /**
     * Vertices rounded to QuickHull's grid: whole numbers along two or three axes, in steps.
     */
    internal final class HullGrid implements Steps
    {
        private static const VERTICES_A_STEP:int = 4000;

        private var _vertices:Vector.<Number>;
        private var _axes:Vector.<Number>;
        private var _dimensions:int;
        private var _points:Vector.<Number>;

        // Of each axis: where the grid begins, and how long a step of it is.
        private var _lows:Vector.<Number> = new Vector.<Number>();
        private var _steps:Vector.<Number> = new Vector.<Number>();

        // The axis under way, where the vertices begin and end on it, and the next vertex to measure or, after that, to snap.
        private var _axis:int = 0;
        private var _low:Number = Infinity;
        private var _high:Number = -Infinity;
        private var _isMeasured:Boolean = false;
        private var _next:int = 0;

        /**
         * @param vertices x, y, z each; along each of the axes they differ
         * @param axes perpendicular unit vectors, three numbers each
         * @param dimensions how many of the axes the grid has: 2 or 3
         */
        public function HullGrid(vertices:Vector.<Number>, axes:Vector.<Number>, dimensions:int)
        {
            _vertices = vertices;
            _axes = axes;
            _dimensions = dimensions;
            _points = new Vector.<Number>(dimensions * (vertices.length / 3));
        }

        /** The vertices on the grid, two or three whole numbers each, from 0 to QuickHull.GRID. */
        public function get points():Vector.<Number>
        {
            return _points;
        }

        /** @inheritDoc */
        public function step():Boolean
        {
            var count:int = _vertices.length / 3;
            var first:int = _next;
            var end:int = Math.min(first + VERTICES_A_STEP, count);
            if (_isMeasured)
            {
                snap(first, end);
            }
            else
            {
                measure(first, end);
            }
            _next = end;
            if (end == count)
            {
                finishPass();
            }
            return _axis < _dimensions;
        }

        /**
         * Where some of the points are in the vertices' space, x, y, z each.
         *
         * @param indices which
         * @param originX x of the point from which the grid's axes count
         * @param originY y of it
         * @param originZ z of it
         */
        public function placesOf(indices:Vector.<int>, originX:Number, originY:Number, originZ:Number):Vector.<Number>
        {
            var placed:Vector.<Number> = new Vector.<Number>(3 * indices.length);
            for (var i:int = 0; i < placed.length; i += 3)
            {
                var x:Number = originX;
                var y:Number = originY;
                var z:Number = originZ;
                for (var axis:int = 0; axis < _dimensions; axis++)
                {
                    var t:Number = _lows[axis] + _points[_dimensions * indices[i / 3] + axis] * _steps[axis];
                    x += t * _axes[3 * axis];
                    y += t * _axes[3 * axis + 1];
                    z += t * _axes[3 * axis + 2];
                }
                placed[i] = x;
                placed[i + 1] = y;
                placed[i + 2] = z;
            }
            return placed;
        }

        private function measure(first:int, end:int):void
        {
            var places:Vector.<Number> = _points;
            var dimensions:int = _dimensions;
            var axisX:Number = _axes[3 * _axis];
            var axisY:Number = _axes[3 * _axis + 1];
            var axisZ:Number = _axes[3 * _axis + 2];
            var low:Number = _low;
            var high:Number = _high;
            var to:int = dimensions * first + _axis;
            var last:int = 3 * end;
            for (var i:int = 3 * first; i < last; i += 3)
            {
                var t:Number = _vertices[i] * axisX + _vertices[i + 1] * axisY + _vertices[i + 2] * axisZ;
                places[to] = t;
                to += dimensions;
                if (t < low)
                {
                    low = t;
                }
                if (t > high)
                {
                    high = t;
                }
            }
            _low = low;
            _high = high;
        }

        private function snap(first:int, end:int):void
        {
            var places:Vector.<Number> = _points;
            var dimensions:int = _dimensions;
            var low:Number = _low;
            var scale:Number = QuickHull.GRID / (_high - low);
            var to:int = dimensions * end;
            for (var i:int = dimensions * first + _axis; i < to; i += dimensions)
            {
                places[i] = int((places[i] - low) * scale + 0.5);
            }
        }

        private function finishPass():void
        {
            _next = 0;
            _isMeasured = !_isMeasured;
            if (!_isMeasured)
            {
                _lows.push(_low);
                _steps.push((_high - _low) / QuickHull.GRID);
                _axis++;
                _low = Infinity;
                _high = -Infinity;
            }
        }
    }
}
