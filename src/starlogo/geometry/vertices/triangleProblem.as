package starlogo.geometry.vertices
{
    /**
     * Describes what is wrong with triangles.
     *
     * @param triangles three vertex indices each; not null, may be empty
     * @param vertexCount the number of vertices
     * @param first the index of the first number that is checked
     * @param end the index after the last one
     * @return null if nothing is wrong, otherwise a sentence that begins with a small letter
     *
     * @private
     */
    public function triangleProblem(triangles:Vector.<uint>, vertexCount:int, first:int = 0, end:int = int.MAX_VALUE):String
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
