package starlogo.models.polygons
{
    /**
     * The power of two by which corners are scaled so that no coordinate is further than 1 from the first corner's, and one is further than a
     * half. It is at most 2^1023. Multiplying by it rounds nothing.
     *
     * @param vertices x, y, z, ...
     * @param corners indices of vertices
     *
     * @private
     */
    internal function unitScaleOf(vertices:Vector.<Number>, corners:Vector.<uint>):Number
    {
        const LARGEST:Number = 8e307;
        var origin:int = 3 * corners[0];
        var extent:Number = 0;
        for (var i:int = 1; i < corners.length; i++)
        {
            var at:int = 3 * corners[i];
            extent = Math.max(extent, Math.abs(vertices[at] - vertices[origin]), Math.abs(vertices[at + 1] - vertices[origin + 1]),
                    Math.abs(vertices[at + 2] - vertices[origin + 2]));
        }
        var scale:Number = 1;
        while (scale * extent > 1)
        {
            scale /= 2;
        }
        while (scale * extent <= 0.5 && scale < LARGEST)
        {
            scale *= 2;
        }
        return scale;
    }
}
