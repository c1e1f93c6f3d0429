package starlogo.models
{
    import starlogo.steps.StepSequence;

    /**
     * Removes the vertices that no surface uses and closes the gaps, in steps.
     *
     * @private
     */
    public final class VertexFilter extends StepSequence
    {
        private static const VERTICES_PER_STEP:int = 4000;
        private static const CORNERS_PER_STEP:int = 20000;

        private var _vertices:Vector.<Number>;
        private var _triangles:Vector.<uint>;

        // A mark for each vertex: 1 if it is used. Then the new index of each vertex that is used.
        private var _marks:Vector.<uint>;

        private var _count:int = 0;

        /**
         * @param vertices x, y, z, ...; changed in place
         * @param triangles indices of used vertices; changed to the new indices
         * @param marks 1 for each vertex that is kept although no triangle uses it, 0 for the others; overwritten
         */
        public function VertexFilter(vertices:Vector.<Number>, triangles:Vector.<uint>, marks:Vector.<uint>)
        {
            _vertices = vertices;
            _triangles = triangles;
            _marks = marks;
            slices(triangles.length, CORNERS_PER_STEP, markUsed).call(addClosing);
        }

        private function markUsed(first:int, end:int):void
        {
            for (var i:int = first; i < end; i++)
            {
                _marks[_triangles[i]] = 1;
            }
        }

        private function addClosing():void
        {
            if (_marks.indexOf(0) >= 0)
            {
                slices(_marks.length, VERTICES_PER_STEP, moveVertices).slices(_triangles.length, CORNERS_PER_STEP, renumber);
            }
        }

        // Moves used vertices to the first free index, and notes their new indices.
        private function moveVertices(first:int, end:int):void
        {
            for (var i:int = first; i < end; i++)
            {
                if (_marks[i] != 0)
                {
                    var from:int = 3 * i;
                    var to:int = 3 * _count;
                    _vertices[to] = _vertices[from];
                    _vertices[int(to + 1)] = _vertices[int(from + 1)];
                    _vertices[int(to + 2)] = _vertices[int(from + 2)];
                    _marks[i] = _count++;
                }
            }
        }

        private function renumber(first:int, end:int):void
        {
            // also without triangles, because slices() calls this once then
            _vertices.length = 3 * _count;
            for (var i:int = first; i < end; i++)
            {
                _triangles[i] = _marks[_triangles[i]];
            }
        }
    }
}
