package starlogo.geometry.vertices
{
    /**
     * Checks vertices and triangles, and describes what is wrong with them. The caller adds the model's name, and throws.
     *
     * @private
     */
    public final class VertexData
    {
        /**
         * Describes what is wrong with vertices.
         *
         * @param vertices x, y, z, x, y, z, ... of at least one vertex; null is wrong too
         * @return null if nothing is wrong, otherwise a sentence that begins with a small letter
         */
        public static function vertexProblem(vertices:Vector.<Number>):String
        {
            if (vertices == null || vertices.length == 0 || vertices.length % 3 != 0)
            {
                return "at least one vertex with three coordinates each is needed, not "
                    + (vertices == null ? "null" : vertices.length + " numbers");
            }
            var length:int = vertices.length;
            for (var i:int = 0; i < length; i++)
            {
                var coordinate:Number = vertices[i];
                // Infinity minus itself is NaN, which equals nothing.
                if (coordinate - coordinate != 0)
                {
                    return "the " + "xyz".charAt(i % 3) + " coordinate of vertex " + int(i / 3)
                        + " must be a finite number, not " + coordinate;
                }
            }
            return null;
        }

        /**
         * Describes what is wrong with triangles.
         *
         * @param triangles three vertex indices each; not null, may be empty
         * @param vertexCount the number of vertices
         * @param first the index of the first number that is checked
         * @param end the index after the last one
         * @return null if nothing is wrong, otherwise a sentence that begins with a small letter
         */
        public static function triangleProblem(triangles:Vector.<uint>, vertexCount:int, first:int = 0, end:int = int.MAX_VALUE):String
        {
            if (triangles.length % 3 != 0)
            {
                return "triangles have three vertices each, but there are " + triangles.length + " indices in all";
            }
            var length:int = Math.min(end, triangles.length);
            var count:uint = vertexCount;
            for (var i:int = first; i < length; i++)
            {
                if (triangles[i] >= count)
                {
                    return "triangle " + int(i / 3) + " names vertex " + triangles[i] + ", the last one is "
                        + (vertexCount - 1);
                }
            }
            return null;
        }
    }
}
