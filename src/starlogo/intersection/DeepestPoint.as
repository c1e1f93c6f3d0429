package starlogo.intersection
{
    import flash.geom.Vector3D;
    import starlogo.convex.ConvexShape;
    import starlogo.convex.FaceNormal;

    /**
     * Finds the point of a convex shape that is farthest against a normal. If there are several, it is their middle. NaN if the normal is NaN.
     *
     * @private
     */
    public final class DeepestPoint
    {
        // Points of the core are equally deep if their depths differ by less than this fraction.
        private static const LEVEL:Number = 1e-12;

        /** The point. */
        public var point:Vector3D = new Vector3D();

        /** Finds the point. Also measures the shape's core along the normal. */
        public function find(shape:ConvexShape, normal:FaceNormal):void
        {
            var p:Vector.<Number> = shape.points;
            normal.measure(p, 0, shape.end);
            var most:Number = normal.least + LEVEL * (normal.greatest - normal.least);
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
            point.x = shape.x + x / count - shape.radius * normal.x;
            point.y = shape.y + y / count - shape.radius * normal.y;
            point.z = shape.z + z / count - shape.radius * normal.z;
        }
    }
}
