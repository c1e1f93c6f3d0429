package starlogo.intersection.sweep
{
    import flash.geom.Vector3D;
    import starlogo.bounding.Sphere;

    /**
     * When a sphere touches another on its way: when its centre is as near to the other's as both radii.
     *
     * @param a moves; a radius of 0 makes it a point
     * @param b in the space of a
     * @param way of a
     * @return from 0 to 1, or RelativeMotion.NEVER
     *
     * @private
     */
    public function sphereSphereImpact(a:Sphere, b:Sphere, way:RelativeMotion):Number
    {
        var centerA:Vector3D = a.center;
        var centerB:Vector3D = b.center;
        return pointPointImpact(centerA.x - centerB.x + way.startX, centerA.y - centerB.y + way.startY, centerA.z - centerB.z + way.startZ,
                way.x, way.y, way.z, a.radius + b.radius);
    }
}
