package starlogo.intersection
{
    import flash.geom.Vector3D;
    import starlogo.convex.ConvexShape;
    import starlogo.convex.FaceNormal;
    import starlogo.convex.Interval;

    /**
     * Finds the point of a convex shape that is farthest against a normal. If there are several, it is their middle. NaN if the normal is NaN.
     *
     * @param interval receives how far the shape's core extends along the normal, relative to the shape's origin
     * @param out receives the point
     * @private
     */
    public function findDeepestPoint(shape:ConvexShape, normal:FaceNormal, interval:Interval, out:Vector3D):void
    {
        // Points of the core are equally deep if their depths differ by less than this fraction.
        const LEVEL:Number = 1e-12;
        var p:Vector.<Number> = shape.points;
        normal.measure(p, 0, shape.end, interval);
        var most:Number = interval.least + LEVEL * (interval.greatest - interval.least);
        var count:int = 0;
        var x:Number = 0;
        var y:Number = 0;
        var z:Number = 0;
        for (var i:int = 0; i < shape.end; i += 3)
        {
            if (normal.x * p[i] + normal.y * p[int(i + 1)] + normal.z * p[int(i + 2)] <= most)
            {
                x += p[i];
                y += p[int(i + 1)];
                z += p[int(i + 2)];
                count++;
            }
        }
        out.x = shape.x + x / count - shape.radius * normal.x;
        out.y = shape.y + y / count - shape.radius * normal.y;
        out.z = shape.z + z / count - shape.radius * normal.z;
    }
}
