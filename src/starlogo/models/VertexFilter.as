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
        private var _newIndices:Vector.<uint>;
        private var _count:int = 0;

        /**
         * @param vertices x, y, z, ...; changed in place
         * @param triangles indices of used vertices; changed to the new indices
         * @param isUsed a number for each vertex; the steps set it to 1 for all vertices of triangles, and then remove the vertices with 0
         */
        public function VertexFilter(vertices:Vector.<Number>, triangles:Vector.<uint>, isUsed:Vector.<uint>)
        {
            _vertices = vertices;
            _triangles = triangles;
            _isUsed = isUsed;
            slices(triangles.length, CORNERS_PER_STEP, markUsed).call(dropUnused);
        }

        private function markUsed(first:int, end:int):void
        {
            var isUsed:Vector.<uint> = _isUsed;
            var corners:Vector.<uint> = _triangles;
            for (var i:int = first; i < end; i++)
            {
                isUsed[corners[i]] = 1;
            }
        }

        private function dropUnused():void
        {
            if (_isUsed.indexOf(0) >= 0)
            {
                _newIndices = new Vector.<uint>(_isUsed.length);
                slices(_isUsed.length, VERTICES_PER_STEP, moveVertices).slices(_triangles.length, CORNERS_PER_STEP, renumber);
            }
        }

        private function moveVertices(first:int, end:int):void
        {
            var vertices:Vector.<Number> = _vertices;
            for (var i:int = first; i < end; i++)
            {
                if (_isUsed[i] != 0)
                {
                    var from:int = 3 * i;
                    var to:int = 3 * _count;
                    vertices[to] = vertices[from];
                    vertices[int(to + 1)] = vertices[int(from + 1)];
                    vertices[int(to + 2)] = vertices[int(from + 2)];
                    _newIndices[i] = _count++;
                }
            }
        }

        private function renumber(first:int, end:int):void
        {
            var triangles:Vector.<uint> = _triangles;
            _vertices.length = 3 * _count;
            for (var i:int = first; i < end; i++)
            {
                triangles[i] = _newIndices[triangles[i]];
            }
        }
    }
}
