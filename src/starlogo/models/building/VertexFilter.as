package starlogo.models.building
{
    import starlogo.steps.StepSequence;

    /**
     * Removes the vertices that no triangle uses and closes the gaps, in steps. If there are no triangles, all vertices stay.
     *
     * @private
     */
    public final class VertexFilter extends StepSequence
    {
        private static const VERTICES_PER_STEP:int = 4000;
        private static const CORNERS_PER_STEP:int = 20000;

        /** By vertex: 1 if a triangle uses it, otherwise 0. When no step is left; null if there are no triangles. */
        public var isUsed:Vector.<uint> = null;

        private var _vertices:Vector.<Number>;
        private var _triangles:Vector.<uint>;

        // the new index of each vertex that is used
        private var _newIndices:Vector.<int>;

        // the number of vertices that are used, so far
        private var _count:int = 0;

        /**
         * @param vertices x, y, z, ...; changed in place
         * @param triangles indices of vertices; changed to the new indices. Both lists need to be complete only when the first step is done
         */
        public function VertexFilter(vertices:Vector.<Number>, triangles:Vector.<uint>)
        {
            _vertices = vertices;
            _triangles = triangles;
            call(addParts);
        }

        private function addParts():void
        {
            if (_triangles.length > 0)
            {
                isUsed = new Vector.<uint>(_vertices.length / 3);
                slices(_triangles.length, CORNERS_PER_STEP, markUsed).call(addClosing);
            }
        }

        private function markUsed(first:int, end:int):void
        {
            for (var i:int = first; i < end; i++)
            {
                isUsed[_triangles[i]] = 1;
            }
        }

        private function addClosing():void
        {
            if (isUsed.indexOf(0) >= 0)
            {
                _newIndices = new Vector.<int>(isUsed.length);
                slices(isUsed.length, VERTICES_PER_STEP, moveVertices).call(cutVertices).slices(_triangles.length, CORNERS_PER_STEP, renumber);
            }
        }

        // Moves used vertices to the first free index, and notes their new indices.
        private function moveVertices(first:int, end:int):void
        {
            for (var i:int = first; i < end; i++)
            {
                if (isUsed[i] != 0)
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
