package starlogo.solid
{
    /**
     * Writes the extents of a triangle: minX, maxX, minY, maxY, minZ, maxZ.
     *
     * @param corners has the triangle: nine numbers, from an index on
     * @param at the index
     * @param out receives the six numbers, from an index on
     * @param to that index
     * @private
     */
    internal function writeTriangleExtents(corners:Vector.<Number>, at:int, out:Vector.<Number>, to:int):void
    {
        for (var axis:int = 0; axis < 3; axis++)
        {
            var p:Number = corners[int(at + axis)];
            var q:Number = corners[int(at + axis + 3)];
            var r:Number = corners[int(at + axis + 6)];
            var low:Number = q < p ? q : p;
            var high:Number = q < p ? p : q;
            out[int(to + 2 * axis)] = r < low ? r : low;
            out[int(to + 2 * axis + 1)] = r > high ? r : high;
        }
    }
}
