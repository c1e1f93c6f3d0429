package starlogo.solid
{
    /**
     * Returns the squared distance of a triangle's extents from other extents. A triangle is asked about once, so its extents are not prepared.
     *
     * @param extents minX, maxX, minY, ...
     * @param corners has nine numbers of the triangle
     * @param at index of the first of them
     * @private
     */
    internal function squaredDistanceToExtents(extents:Vector.<Number>, corners:Vector.<Number>, at:int):Number
    {
        var squared:Number = 0;
        for (var axis:int = 0; axis < 6; axis += 2)
        {
            var p:Number = corners[at];
            var q:Number = corners[int(at + 3)];
            var r:Number = corners[int(at + 6)];
            var low:Number = extents[axis];
            var high:Number = extents[int(axis + 1)];
            var distance:Number = 0;
            if (p > high && q > high && r > high)
            {
                distance = p < q ? p : q;
                distance = distance < r ? distance : r;
                distance -= high;
            }
            else if (p < low && q < low && r < low)
            {
                distance = p > q ? p : q;
                distance = distance > r ? distance : r;
                distance = low - distance;
            }
            squared += distance * distance;
            at++;
        }
        return squared;
    }
}
