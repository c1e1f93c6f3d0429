package starlogo.intersection.distance
{
    import starlogo.convex.ClosestPoints;

    /**
     * Finds the distance of two structures and their closest points from the gap between their cores. If the structures overlap, both points
     * become one point. It lies on the line through the cores' closest points, in the middle of the part inside of both structures.
     *
     * @param gap the gap between the cores, and the radii
     * @param out has the first core's closest point in aX, aY, aZ; receives the distance and both points
     * @private
     */
    public function moveToSurfaces(gap:RoundGap, out:ClosestPoints):void
    {
        var x:Number = gap.x;
        var y:Number = gap.y;
        var z:Number = gap.z;
        var radiusA:Number = gap.radiusA;
        var radiusB:Number = gap.radiusB;
        var length:Number = Math.sqrt(x * x + y * y + z * z);
        // how far the two points are from the first core's closest point, towards the second core
        var atA:Number = radiusA;
        var atB:Number = length - radiusB;
        out.distance = atB - atA;
        if (!(out.distance > 0))
        {
            out.distance = 0;
            var low:Number = atB > -radiusA ? atB : -radiusA;
            var high:Number = length + radiusB;
            high = high < radiusA ? high : radiusA;
            atA = atB = (low + high) / 2;
        }
        if (length > 0)
        {
            x /= length;
            y /= length;
            z /= length;
        }
        out.bX = out.aX - atB * x;
        out.bY = out.aY - atB * y;
        out.bZ = out.aZ - atB * z;
        out.aX -= atA * x;
        out.aY -= atA * y;
        out.aZ -= atA * z;
    }
}
