package starlogo.solid
{
    import starlogo.geometry.Tolerances;
    import starlogo.steps.StepSequence;

    /**
     * Finds the vertices that are at the same place, within a tolerance, because rounding may have separated the vertices of a seam. The
     * vertices are sorted along a direction that is skew to the axes along which models are built. So vertices near each other are near in
     * this order, and the vertices of a flat wall spread over it.
     */
    internal final class Welding extends StepSequence
    {
        private static const VERTICES_PER_STEP:int = 500;

        // The direction, a unit vector.
        private static const SKEW_X:Number = 0.5390711;
        private static const SKEW_Y:Number = 0.2717819;
        private static const SKEW_Z:Number = 0.7972148;

        /** For each vertex, the first vertex in the order at the same place. */
        public var welded:Vector.<int>;

        /** The largest distance of a vertex from the one to which it is welded. */
        public var widestGap:Number = 0;

        private var _vertices:Vector.<Number>;
        private var _tolerance:Number = 0;
        private var _keys:Array;
        private var _order:Array;

        // The vertices to which others are welded, in the order, and the first of them that is still near.
        private var _places:Vector.<int> = new Vector.<int>();
        private var _nearPlace:int = 0;

        /**
         * @param vertices x, y, z of each
         */
        public function Welding(vertices:Vector.<Number>)
        {
            _vertices = vertices;
            var count:int = vertices.length / 3;
            welded = new Vector.<int>(count, true);
            _keys = new Array(count);
            slices(count, VERTICES_PER_STEP, measure).call(sort).slices(count, VERTICES_PER_STEP, weld);
        }

        // At first, the tolerance is the largest coordinate.
        private function measure(first:int, end:int):void
        {
            for (var i:int = first; i < end; i++)
            {
                var x:Number = _vertices[3 * i];
                var y:Number = _vertices[3 * i + 1];
                var z:Number = _vertices[3 * i + 2];
                _keys[i] = x * SKEW_X + y * SKEW_Y + z * SKEW_Z;
                _tolerance = Math.max(_tolerance, Math.abs(x), Math.abs(y), Math.abs(z));
            }
        }

        private function sort():void
        {
            _order = _keys.sort(Array.NUMERIC | Array.RETURNINDEXEDARRAY);
            _tolerance *= Tolerances.WELDING;
        }

        private function weld(first:int, end:int):void
        {
            for (var i:int = first; i < end; i++)
            {
                var vertex:int = _order[i];
                welded[vertex] = placeOf(vertex);
            }
        }

        private function placeOf(vertex:int):int
        {
            var key:Number = _keys[vertex];
            while (_nearPlace < _places.length && key - _keys[_places[_nearPlace]] > _tolerance)
            {
                _nearPlace++;
            }
            for (var i:int = _places.length - 1; i >= _nearPlace; i--)
            {
                var gap:Number = distanceOf(vertex, _places[i]);
                if (gap <= _tolerance)
                {
                    widestGap = gap > widestGap ? gap : widestGap;
                    return _places[i];
                }
            }
            _places.push(vertex);
            return vertex;
        }

        private function distanceOf(a:int, b:int):Number
        {
            var x:Number = _vertices[3 * a] - _vertices[3 * b];
            var y:Number = _vertices[3 * a + 1] - _vertices[3 * b + 1];
            var z:Number = _vertices[3 * a + 2] - _vertices[3 * b + 2];
            return Math.sqrt(x * x + y * y + z * z);
        }
    }
}
