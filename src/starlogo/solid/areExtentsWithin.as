package starlogo.solid
{
    import starlogo.hierarchy.BoxTree;

    /**
     * Returns whether a triangle's extents are within a distance of other extents. A triangle is asked about once, so its extents are not prepared. It is
     * no method of the tree, so that games without exact tests need not load it.
     *
     * @param distance at least 0
     * @param extents minX, maxX, minY, ...
     * @param tree has the triangle; its corners are listed
     * @param index the triangle's primitive index
     * @private
     */
    internal function areExtentsWithin(distance:Number, extents:Vector.<Number>, tree:BoxTree, index:int):Boolean
    {
        var points:Vector.<Number> = tree.vertices;
        var a:int = tree.cornerOffsets[int(3 * index)];
        var b:int = tree.cornerOffsets[int(3 * index + 1)];
        var c:int = tree.cornerOffsets[int(3 * index + 2)];
        var left:Number = distance * distance;
        for (var axis:int = 0; axis < 6; axis += 2)
        {
            var atA:Number = points[a];
            var atB:Number = points[b];
            var atC:Number = points[c];
            var low:Number = extents[axis];
            var high:Number = extents[int(axis + 1)];
            var gap:Number = 0;
            if (atA > high && atB > high && atC > high)
            {
                gap = atA < atB ? atA : atB;
                gap = gap < atC ? gap : atC;
                gap -= high;
            }
            else if (atA < low && atB < low && atC < low)
            {
                gap = atA > atB ? atA : atB;
                gap = gap > atC ? gap : atC;
                gap = low - gap;
            }
            left -= gap * gap;
            if (left < 0)
            {
                return false;
            }
            a++;
            b++;
            c++;
        }
        return true;
    }
}
