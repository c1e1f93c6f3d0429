package starlogo.solid
{
    import starlogo.hierarchy.TriangleMesh;

    /**
     * Returns the squared distance of a triangle's extents from other extents. A triangle is asked about once, so its extents are not prepared. It is no
     * method of the mesh, so that games without exact tests need not load it.
     *
     * @param extents minX, maxX, minY, ...
     * @param mesh has the triangle
     * @param slot the triangle's slot
     * @private
     */
    internal function squaredDistanceToExtents(extents:Vector.<Number>, mesh:TriangleMesh, slot:int):Number
    {
        var points:Vector.<Number> = mesh.vertices;
        var a:int = mesh.corners[int(3 * slot)];
        var b:int = mesh.corners[int(3 * slot + 1)];
        var c:int = mesh.corners[int(3 * slot + 2)];
        var squared:Number = 0;
        for (var axis:int = 0; axis < 6; axis += 2)
        {
            var atA:Number = points[a];
            var atB:Number = points[b];
            var atC:Number = points[c];
            var low:Number = extents[axis];
            var high:Number = extents[int(axis + 1)];
            var distance:Number = 0;
            if (atA > high && atB > high && atC > high)
            {
                distance = atA < atB ? atA : atB;
                distance = distance < atC ? distance : atC;
                distance -= high;
            }
            else if (atA < low && atB < low && atC < low)
            {
                distance = atA > atB ? atA : atB;
                distance = distance > atC ? distance : atC;
                distance = low - distance;
            }
            squared += distance * distance;
            a++;
            b++;
            c++;
        }
        return squared;
    }
}
