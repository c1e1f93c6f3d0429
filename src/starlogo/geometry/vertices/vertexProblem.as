package starlogo.geometry.vertices
{
    /**
     * Describes what is wrong with vertices.
     *
     * @param vertices x, y, z, x, y, z, ... of at least one vertex; null is wrong too
     * @return null if nothing is wrong, otherwise a sentence that begins with a small letter
     *
     * @private
     */
    public function vertexProblem(vertices:Vector.<Number>):String
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
}
