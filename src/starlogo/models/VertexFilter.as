package starlogo.models
{
    /** Leaves out the vertices that no surface uses. */
    internal final class VertexFilter
    {
        /** All is static. */
        public function VertexFilter()
        {
        }

        /**
         * Closes the gaps, in place.
         *
         * @param vertices x, y, z, ...
         * @param triangles indices of used vertices; changed to where these are then
         * @param isUsed a number for each vertex, 0 for those to leave out
         */
        internal static function keepUsed(vertices:Vector.<Number>, triangles:Vector.<uint>, isUsed:Vector.<uint>):void
        {
            if (isUsed.indexOf(0) < 0)
            {
                return;
            }
            var newIndices:Vector.<uint> = new Vector.<uint>(isUsed.length);
            var count:int = 0;
            for (var i:int = 0; i < isUsed.length; i++)
            {
                if (isUsed[i] != 0)
                {
                    newIndices[i] = count;
                    vertices[3 * count] = vertices[3 * i];
                    vertices[3 * count + 1] = vertices[3 * i + 1];
                    vertices[3 * count + 2] = vertices[3 * i + 2];
                    count++;
                }
            }
            vertices.length = 3 * count;
            for (i = 0; i < triangles.length; i++)
            {
                triangles[i] = newIndices[triangles[i]];
            }
        }
    }
}
