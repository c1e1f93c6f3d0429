package starlogo.motion
{
    import flash.geom.Vector3D;
    import starlogo.bounding.Sphere;

    /**
     * When a sphere touches another on its way: where the line of its centre enters the sphere of both radii, in closed form.
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
        var wayX:Number = way.x;
        var wayY:Number = way.y;
        var wayZ:Number = way.z;
        var x:Number = centerA.x - centerB.x + way.startX;
        var y:Number = centerA.y - centerB.y + way.startY;
        var z:Number = centerA.z - centerB.z + way.startZ;
        var reach:Number = a.radius + b.radius;
        reach *= reach;
        if (x * x + y * y + z * z <= reach)
        {
            return 0;
        }
        var closing:Number = -(x * wayX + y * wayY + z * wayZ);
        if (!(closing > 0))
        {
            return Way.NEVER;
        }
        // from the point of the line that is nearest, as far back as half the chord
        var waySquared:Number = wayX * wayX + wayY * wayY + wayZ * wayZ;
        var nearest:Number = closing / waySquared;
        x += nearest * wayX;
        y += nearest * wayY;
        z += nearest * wayZ;
        var half:Number = reach - (x * x + y * y + z * z);
        if (half < 0)
        {
            return Way.NEVER;
        }
        var time:Number = nearest - Math.sqrt(half / waySquared);
        if (time > 1)
        {
            return Way.NEVER;
        }
        return time > 0 ? time : 0;
    }
}
