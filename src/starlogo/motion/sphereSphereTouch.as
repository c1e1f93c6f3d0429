package starlogo.motion
{
    import flash.geom.Vector3D;
    import starlogo.bounding.Sphere;

    /**
     * When a sphere touches another on its way: when its centre is as near to the other's as both radii.
     *
     * @param a moves; a radius of 0 makes it a point
     * @param b in the space of a
     * @param way of a
     * @return from 0 to 1, or Way.NEVER
     *
     * @private
     */
    public function sphereSphereTouch(a:Sphere, b:Sphere, way:Way):Number
    {
        var centerA:Vector3D = a.center;
        var centerB:Vector3D = b.center;
        return pointPointTouch(centerA.x - centerB.x + way.startX, centerA.y - centerB.y + way.startY, centerA.z - centerB.z + way.startZ,
                way.x, way.y, way.z, a.radius + b.radius);
    }
}
