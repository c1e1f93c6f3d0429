package starlogo.geometry.hull
{
    import starlogo.steps.StepSequence;

    /**
     * Rounds vertices to QuickHull's grid of whole numbers along three axes. It works in steps. Vertices in a plane are put on the grid's
     * floor. One more point, the last one, is then above them, so that all points span a volume.
     *
     * @private
     */
    public final class HullGrid extends StepSequence
    {
        private static const VERTICES_PER_STEP:int = 4000;

        /** The vertices on the grid, three whole numbers each, from 0 to QuickHull.GRID. Complete after the last step. */
        public var points:Vector.<Number>;

        private var _vertices:Vector.<Number>;
        private var _axes:Vector.<Number>;
        private var _isPlane:Boolean;

        // The smallest and the largest place of the vertices on each axis, and the current axis.
        private var _lows:Vector.<Number> = new <Number>[Infinity, Infinity, Infinity];
        private var _highs:Vector.<Number> = new <Number>[-Infinity, -Infinity, -Infinity];
        private var _axis:int = -1;

        /**
         * @param vertices x, y, z of each; they must differ along each of the axes
         * @param axes perpendicular unit vectors, three numbers each
         * @param isPlane whether the vertices are in the plane of the first two axes
         */
        public function HullGrid(vertices:Vector.<Number>, axes:Vector.<Number>, isPlane:Boolean)
        {
            _vertices = vertices;
            _axes = axes;
            _isPlane = isPlane;
            var count:int = vertices.length / 3;
            points = new Vector.<Number>(3 * count);
            if (isPlane)
            {
                points.push(QuickHull.GRID / 2, QuickHull.GRID / 2, QuickHull.GRID);
            }
            for (var axis:int = 0; axis < 3; axis++)
            {
                slices(count, VERTICES_PER_STEP, measure).slices(count, VERTICES_PER_STEP, snap);
            }
        }

        // Writes the vertices' places along the next axis, before rounding.
        private function measure(first:int, end:int):void
        {
            if (first == 0)
            {
                _axis++;
            }
            var places:Vector.<Number> = points;
            var vertices:Vector.<Number> = _vertices;
            var axisX:Number = _axes[3 * _axis];
            var axisY:Number = _axes[3 * _axis + 1];
            var axisZ:Number = _axes[3 * _axis + 2];
            var low:Number = _lows[_axis];
            var high:Number = _highs[_axis];
            var to:int = 3 * first + _axis;
            var last:int = 3 * end;
            for (var i:int = 3 * first; i < last; i += 3)
            {
                var t:Number = vertices[i] * axisX + vertices[int(i + 1)] * axisY + vertices[int(i + 2)] * axisZ;
                places[to] = t;
                to += 3;
                if (t < low)
                {
                    low = t;
                }
                if (t > high)
                {
                    high = t;
                }
            }
            _lows[_axis] = low;
            _highs[_axis] = high;
        }

        private function snap(first:int, end:int):void
        {
            var places:Vector.<Number> = points;
            var low:Number = _lows[_axis];
            var scale:Number = _isPlane && _axis == 2 ? 0 : QuickHull.GRID / (_highs[_axis] - low);
            var to:int = 3 * end;
            for (var i:int = 3 * first + _axis; i < to; i += 3)
            {
                places[i] = int((places[i] - low) * scale + 0.5);
            }
        }
    }
}
