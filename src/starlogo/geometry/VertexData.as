package starlogo.geometry
{
    /**
     * Says what is wrong with vertices and triangles; the caller adds which model has them, and throws.
     *
     * @private
     */
    public final class VertexData
    {
        /** All is static. */
        public function VertexData()
        {
        }

        /**
         * What keeps vertices from being used.
         *
         * @param vertices x, y, z, x, y, z, ... of at least one vertex; may be null, which is wrong
         * @return null if they are fine, else a sentence that begins small
         */
        public static function vertexProblem(vertices:Vector.<Number>):String
        {
            if (vertices == null || vertices.length == 0 || vertices.length % 3 != 0)
            {
                return "three coordinates for each of at least one vertex are needed, not "
                    + (vertices == null ? "null" : vertices.length + " numbers");
            }
            var length:int = vertices.length;
            for (var i:int = 0; i < length; i++)
            {
                var coordinate:Number = vertices[i];
                // infinity minus itself is NaN, which equals nothing
                if (coordinate - coordinate != 0)
                {
                    return "the " + "xyz".charAt(i % 3) + " coordinate of vertex " + int(i / 3)
                        + " must be a finite number, not " + coordinate;
                }
            }
            return null;
        }

        /** Whether numbers are the same to the last bit, and the sign of zeros. */
        public static function areSame(a:Vector.<Number>, b:Vector.<Number>):Boolean
        {
            for (var i:int = 0; i < a.length && a.length == b.length; i++)
            {
                if (a[i] != b[i] || a[i] == 0 && 1 / a[i] != 1 / b[i])
                {
                    return false;
                }
            }
            return a.length == b.length;
        }

        /**
         * What keeps triangles from being used.
         *
         * @param triangles three vertex indices each; not null, may be empty
         * @param vertexCount how many vertices there are
         * @return null if they are fine, else a sentence that begins small
         */
        public static function triangleProblem(triangles:Vector.<uint>, vertexCount:int):String
        {
            if (triangles.length % 3 != 0)
            {
                return "triangles have three vertices each, but there are " + triangles.length + " indices in all";
            }
            var length:int = triangles.length;
            var end:uint = vertexCount;
            for (var i:int = 0; i < length; i++)
            {
                if (triangles[i] >= end)
                {
                    return "triangle " + int(i / 3) + " names vertex " + triangles[i] + ", the last one is "
                        + (vertexCount - 1);
                }
            }
            return null;
        }
    }
}
