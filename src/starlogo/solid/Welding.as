package starlogo.solid
{
    import starlogo.geometry.Tolerances;
    import starlogo.steps.StepSequence;

    /**
     * Finds the vertices that are at the same place, up to a tolerance: those of a seam, whose coordinates rounding may have
     * parted. Vertices are sorted along a direction askew to all that models are built along, so that those near each other
     * are near in that order, and a flat wall is not all in one place of it.
     */
    internal final class Welding extends StepSequence
    {
        private static const VERTICES_PER_STEP:int = 500;

        // a unit vector
        private static const SKEW_X:Number = 0.5390711;
        private static const SKEW_Y:Number = 0.2717819;
        private static const SKEW_Z:Number = 0.7972148;

        /** For each vertex, the first one in order that is at its place. */
        public var welded:Vector.<int>;

        /** The largest distance of a vertex from the one that it is welded to. */
        public var widestGap:Number = 0;

        private var _vertices:Vector.<Number>;
        private var _tolerance:Number = 0;
        private var _keys:Array;
        private var _order:Array;

        // The vertices that others are welded to, in order, and the first of them that is not far behind.
        private var _places:Vector.<int> = new Vector.<int>();
        private var _nearPlace:int = 0;

        /**
         * @param vertices x, y, z each
         */
        public function Welding(vertices:Vector.<Number>)
        {
            _vertices = vertices;
            var count:int = vertices.length / 3;
            welded = new Vector.<int>(count, true);
            _keys = new Array(count);
            slices(count, VERTICES_PER_STEP, measure).call(sort).slices(count, VERTICES_PER_STEP, weld);
        }

        // The tolerance is the largest coordinate at first.
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
