package support
{
    import flash.geom.Vector3D;
    import starlogo.bounding.Hull;
    import starlogo.convex.ConvexShape;
    import starlogo.engine;

    use namespace engine;

    /**
     * Sets a convex shape to the hull of points.
     *
     * @param origin the origin of the points
     * @param points x, y, z of each
     * @return how many corners it has
     */
    public function setHull(shape:ConvexShape, origin:Vector3D, points:Vector.<Number>):int
    {
        var hull:Hull = new Hull(points);
        // the origin is kept to the last bit, where the hull's own place would be rounded
        shape.setHull(origin, hull.corners, hull.topology.faces, hull.topology.edges);
        return hull.corners.length / 3;
    }
}
