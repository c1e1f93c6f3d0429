package evaluation.literal
{
    import flash.geom.Vector3D;
    import starlogo.bounding.Sphere;

    /**
     * Ritter's sphere as the thesis describes it (§3.4.1): around a vertex and the one farthest from it, then grown for each vertex outside, in
     * the order of the model's vertices.
     *
     * @param vertices x, y, z each
     * @param first the index of the vertex to begin with; the thesis takes any
     */
    public function ritterSphere(vertices:Vector.<Number>, first:int):Sphere
    {
        var points:Vector.<Vector3D> = new Vector.<Vector3D>();
        for (var i:int = 0; i < vertices.length; i += 3)
        {
            points.push(new Vector3D(vertices[i], vertices[i + 1], vertices[i + 2]));
        }
        var farthest:Vector3D = points[first];
        for each (var point:Vector3D in points)
        {
            if (Vector3D.distance(points[first], point) > Vector3D.distance(points[first], farthest))
            {
                farthest = point;
            }
        }
        var center:Vector3D = points[first].add(farthest);
        center.scaleBy(0.5);
        var radius:Number = Vector3D.distance(points[first], farthest) / 2;
        for each (point in points)
        {
            var distance:Number = Vector3D.distance(center, point);
            if (distance > radius)
            {
                // just large enough for the sphere so far and the vertex
                var larger:Number = (radius + distance) / 2;
                var way:Vector3D = point.subtract(center);
                way.scaleBy((larger - radius) / distance);
                center = center.add(way);
                radius = larger;
            }
        }
        return new Sphere(center, radius);
    }
}
