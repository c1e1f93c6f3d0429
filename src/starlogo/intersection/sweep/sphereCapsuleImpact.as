package starlogo.intersection.sweep
{
    import flash.geom.Vector3D;
    import starlogo.bounding.Capsule;
    import starlogo.bounding.Sphere;
    import starlogo.geometry.Tolerances;

    /**
     * When a sphere touches a capsule on its way: Newton's method on the distance from its centre to the capsule's segment.
     *
     * @param sphere moves; a radius of 0 makes it a point
     * @param capsule in the space of the sphere; it may have no length
     * @param way of the sphere
     * @return from 0 to 1, or RelativeMotion.NEVER
     *
     * @private
     */
    public function sphereCapsuleImpact(sphere:Sphere, capsule:Capsule, way:RelativeMotion):Number
    {
        var start:Vector3D = capsule.start;
        var end:Vector3D = capsule.end;
        var center:Vector3D = sphere.center;
        var axisX:Number = end.x - start.x;
        var axisY:Number = end.y - start.y;
        var axisZ:Number = end.z - start.z;
        var lengthSquared:Number = axisX * axisX + axisY * axisY + axisZ * axisZ;
        var fromX:Number = center.x - start.x + way.startX;
        var fromY:Number = center.y - start.y + way.startY;
        var fromZ:Number = center.z - start.z + way.startZ;
        var wayX:Number = way.x;
        var wayY:Number = way.y;
        var wayZ:Number = way.z;
        var radii:Number = sphere.radius + capsule.radius;
        var reach:Number = radii * Tolerances.TOUCHING + way.rounding();
        reach *= reach;
        var time:Number = 0;
        for (var step:int = 0; step < Newton.MOST_STEPS; step++)
        {
            var x:Number = fromX + time * wayX;
            var y:Number = fromY + time * wayY;
            var z:Number = fromZ + time * wayZ;
            var along:Number = x * axisX + y * axisY + z * axisZ;
            if (along > 0)
            {
                along = along < lengthSquared ? along / lengthSquared : 1;
                x -= along * axisX;
                y -= along * axisY;
                z -= along * axisZ;
            }
            var squared:Number = x * x + y * y + z * z;
            var closing:Number = -(x * wayX + y * wayY + z * wayZ);
            if (squared <= reach)
            {
                return Newton.lastStep(time, squared, reach, radii, closing);
            }
            var next:Number = Newton.next(time, squared, radii, closing);
            if (!(next > time))
            {
                return time;
            }
            if (next > 1)
            {
                return RelativeMotion.NEVER;
            }
            time = next;
        }
        return time;
    }
}
