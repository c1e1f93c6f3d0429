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

        private var _isUsed:Vector.<uint>;

        // the new index of each vertex that is used, and the number of these
        private var _newIndices:Vector.<int>;
        private var _count:int = 0;

        /**
         * @param vertices x, y, z, ...; changed in place
         * @param triangles indices of used vertices; changed to the new indices
         * @param isUsed 1 for each vertex that is kept although no triangle uses it, 0 for the others; the triangles' vertices get a 1
         */
        public function VertexFilter(vertices:Vector.<Number>, triangles:Vector.<uint>, isUsed:Vector.<uint>)
        {
            _vertices = vertices;
            _triangles = triangles;
            _isUsed = isUsed;
            slices(triangles.length, CORNERS_PER_STEP, markUsed).call(addClosing);
        }

        private function markUsed(first:int, end:int):void
        {
            for (var i:int = first; i < end; i++)
            {
                _isUsed[_triangles[i]] = 1;
            }
        }

        private function addClosing():void
        {
            if (_isUsed.indexOf(0) >= 0)
            {
                _newIndices = new Vector.<int>(_isUsed.length);
                slices(_isUsed.length, VERTICES_PER_STEP, moveVertices).call(cutVertices).slices(_triangles.length, CORNERS_PER_STEP, renumber);
            }
        }

        // Moves used vertices to the first free index, and notes their new indices.
        private function moveVertices(first:int, end:int):void
        {
            for (var i:int = first; i < end; i++)
            {
                if (_isUsed[i] != 0)
                {
                    var from:int = 3 * i;
                    var to:int = 3 * _count;
                    _vertices[to] = _vertices[from];
                    _vertices[int(to + 1)] = _vertices[int(from + 1)];
                    _vertices[int(to + 2)] = _vertices[int(from + 2)];
                    _newIndices[i] = _count++;
                }
            }
        }

        private function cutVertices():void
        {
            _vertices.length = 3 * _count;
        }

        private function renumber(first:int, end:int):void
        {
            for (var i:int = first; i < end; i++)
            {
                _triangles[i] = _newIndices[_triangles[i]];
            }
        }
    }
}
