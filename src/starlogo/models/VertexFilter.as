package starlogo.models
{
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;

    /**
     * Removes the vertices that no surface uses and closes the gaps.
     *
     * @private
     */
    public final class VertexFilter
    {
        private static const VERTICES_PER_STEP:int = 4000;
        private static const CORNERS_PER_STEP:int = 20000;

        /**
         * The steps that remove them.
         *
         * @param vertices x, y, z, ...; changed in place
         * @param triangles indices of used vertices; changed to the new indices
         * @param isUsed a number for each vertex; the steps set it to 1 for all vertices of triangles, and remove the vertices with 0. Then
         * it may have the new indices
         */
        public static function removing(vertices:Vector.<Number>, triangles:Vector.<uint>, isUsed:Vector.<uint>):Steps
        {
            return new StepSequence().slices(triangles.length, CORNERS_PER_STEP, function(first:int, end:int):void
                {
                    markUsed(triangles, first, end, isUsed);
                }).begin(function():Steps
                {
                    return isUsed.indexOf(0) < 0 ? null : closingGaps(vertices, triangles, isUsed);
                });
        }

        private static function closingGaps(vertices:Vector.<Number>, triangles:Vector.<uint>, isUsed:Vector.<uint>):Steps
        {
            var count:int = 0;
            return new StepSequence().slices(isUsed.length, VERTICES_PER_STEP, function(first:int, end:int):void
                {
                    count = moveVertices(vertices, first, end, isUsed, count);
                }).slices(triangles.length, CORNERS_PER_STEP, function(first:int, end:int):void
                {
                    vertices.length = 3 * count;
                    renumber(triangles, first, end, isUsed);
                });
        }

        private static function markUsed(corners:Vector.<uint>, first:int, end:int, isUsed:Vector.<uint>):void
        {
            for (var i:int = first; i < end; i++)
            {
                isUsed[corners[i]] = 1;
            }
        }

        // Moves used vertices to a next index and the ones after it, and notes the new indices. Returns the index after the last one.
        private static function moveVertices(vertices:Vector.<Number>, first:int, end:int, isUsed:Vector.<uint>, next:int):int
        {
            for (var i:int = first; i < end; i++)
            {
                if (isUsed[i] != 0)
                {
                    var from:int = 3 * i;
                    var to:int = 3 * next;
                    vertices[to] = vertices[from];
                    vertices[int(to + 1)] = vertices[int(from + 1)];
                    vertices[int(to + 2)] = vertices[int(from + 2)];
                    isUsed[i] = next++;
                }
            }
            return next;
        }

        private static function renumber(triangles:Vector.<uint>, first:int, end:int, newIndices:Vector.<uint>):void
        {
            for (var i:int = first; i < end; i++)
            {
                triangles[i] = newIndices[triangles[i]];
            }
        }
    }
}
