package starlogo.geometry
{
    import starlogo.steps.Steps;

    /**
     * Vertices rounded to QuickHull's grid: whole numbers along two or three axes. A step rounds along one of the axes.
     */
    internal final class HullGrid implements Steps
    {
        private var _vertices:Vector.<Number>;
        private var _axes:Vector.<Number>;
        private var _dimensions:int;
        private var _points:Vector.<Number>;

        // Of each axis: where the grid begins, and how long a step of it is.
        private var _lows:Vector.<Number> = new Vector.<Number>();
        private var _steps:Vector.<Number> = new Vector.<Number>();

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
            snap(_lows.length);
            return _lows.length < _dimensions;
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

        private function snap(axis:int):void
        {
            var snapped:Vector.<Number> = _points;
            var dimensions:int = _dimensions;
            var axisX:Number = _axes[3 * axis];
            var axisY:Number = _axes[3 * axis + 1];
            var axisZ:Number = _axes[3 * axis + 2];
            var low:Number = Infinity;
            var high:Number = -Infinity;
            var length:int = _vertices.length;
            var to:int = axis;
            var i:int;
            for (i = 0; i < length; i += 3)
            {
                var t:Number = _vertices[i] * axisX + _vertices[i + 1] * axisY + _vertices[i + 2] * axisZ;
                snapped[to] = t;
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
            var scale:Number = QuickHull.GRID / (high - low);
            length = snapped.length;
            for (i = axis; i < length; i += dimensions)
            {
                snapped[i] = int((snapped[i] - low) * scale + 0.5);
            }
            _lows.push(low);
            _steps.push((high - low) / QuickHull.GRID);
        }
    }
}
