package starlogo.models
{
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;

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
        private var _isUsed:Vector.<uint>;

        /**
         * @param vertices x, y, z, ...; changed in place
         * @param triangles indices of used vertices; changed to the new indices
         * @param isUsed a number for each vertex; the steps set it to 1 for all vertices of triangles, and remove the vertices with 0
         */
        public function VertexFilter(vertices:Vector.<Number>, triangles:Vector.<uint>, isUsed:Vector.<uint>)
        {
            _vertices = vertices;
            _triangles = triangles;
            _isUsed = isUsed;
            slices(triangles.length, CORNERS_PER_STEP, markUsed).begin(closingGaps);
        }

        private function markUsed(first:int, end:int):void
        {
            for (var i:int = first; i < end; i++)
            {
                _isUsed[_triangles[i]] = 1;
            }
        }

        private function closingGaps():Steps
        {
            if (_isUsed.indexOf(0) < 0)
            {
                return null;
            }
            var newIndices:Vector.<uint> = new Vector.<uint>(_isUsed.length, true);
            var count:int = 0;
            return new StepSequence().slices(_isUsed.length, VERTICES_PER_STEP, function(first:int, end:int):void
                {
                    count = moveVertices(first, end, count, newIndices);
                }).slices(_triangles.length, CORNERS_PER_STEP, function(first:int, end:int):void
                {
                    _vertices.length = 3 * count;
                    renumber(first, end, newIndices);
                });
        }

        // Moves used vertices to the first free index, and notes the new indices. Returns the next free index.
        private function moveVertices(first:int, end:int, free:int, newIndices:Vector.<uint>):int
        {
            for (var i:int = first; i < end; i++)
            {
                if (_isUsed[i] != 0)
                {
                    var from:int = 3 * i;
                    var to:int = 3 * free;
                    _vertices[to] = _vertices[from];
                    _vertices[int(to + 1)] = _vertices[int(from + 1)];
                    _vertices[int(to + 2)] = _vertices[int(from + 2)];
                    newIndices[i] = free++;
                }
            }
            return free;
        }

        private function renumber(first:int, end:int, newIndices:Vector.<uint>):void
        {
            for (var i:int = first; i < end; i++)
            {
                _triangles[i] = newIndices[_triangles[i]];
            }
        }
    }
}
