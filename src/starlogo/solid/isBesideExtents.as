package starlogo.solid
{
    /**
     * Whether a triangle is beyond one side of extents. One branch decides by all comparisons together, because processors predict single ones badly.
     *
     * @param extents minX, maxX, minY, ...
     * @param corners has nine numbers of the triangle
     * @param at index of the first of them
     * @private
     */
    internal function isBesideExtents(extents:Vector.<Number>, corners:Vector.<Number>, at:int):Boolean
    {
        var isBeside:int = 0;
        for (var axis:int = 0; axis < 6; axis += 2)
        {
            var p:Number = corners[at];
            var q:Number = corners[int(at + 3)];
            var r:Number = corners[int(at + 6)];
            var low:Number = extents[axis];
            var high:Number = extents[int(axis + 1)];
            isBeside |= int(p > high) & int(q > high) & int(r > high) | int(p < low) & int(q < low) & int(r < low);
            at++;
        }
        return isBeside != 0;
    }
}
