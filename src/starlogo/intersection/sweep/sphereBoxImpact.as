package starlogo.intersection.sweep
{
    import flash.geom.Vector3D;
    import starlogo.bounding.Box;
    import starlogo.bounding.Sphere;
    import starlogo.geometry.Tolerances;

    /**
     * When a sphere touches a box on its way: Newton's method on the distance from its centre to the box.
     *
     * @param sphere moves; a radius of 0 makes it a point
     * @param box in the space of the sphere; half-extents may be 0
     * @param way of the sphere
     * @return from 0 to 1, or RelativeMotion.NEVER
     *
     * @private
     */
    public function sphereBoxImpact(sphere:Sphere, box:Box, way:RelativeMotion):Number
    {
        var center:Vector3D = sphere.center;
        var middle:Vector3D = box.center;
        var x:Number = center.x - middle.x + way.startX;
        var y:Number = center.y - middle.y + way.startY;
        var z:Number = center.z - middle.z + way.startZ;
        var wayX:Number = way.x;
        var wayY:Number = way.y;
        var wayZ:Number = way.z;

        // In the box's axes: where the centre is at time 0, p, and its way, d.
        var axis:Vector3D = box.axisX;
        var axisX:Number = axis.x;
        var axisY:Number = axis.y;
        var axisZ:Number = axis.z;
        var px:Number = axisX * x + axisY * y + axisZ * z;
        var dx:Number = axisX * wayX + axisY * wayY + axisZ * wayZ;
        axis = box.axisY;
        axisX = axis.x;
        axisY = axis.y;
        axisZ = axis.z;
        var py:Number = axisX * x + axisY * y + axisZ * z;
        var dy:Number = axisX * wayX + axisY * wayY + axisZ * wayZ;
        axis = box.axisZ;
        axisX = axis.x;
        axisY = axis.y;
        axisZ = axis.z;
        var pz:Number = axisX * x + axisY * y + axisZ * z;
        var dz:Number = axisX * wayX + axisY * wayY + axisZ * wayZ;
        var halfX:Number = box.halfX;
        var halfY:Number = box.halfY;
        var halfZ:Number = box.halfZ;
        var radius:Number = sphere.radius;
        var reach:Number = radius * Tolerances.TOUCHING + way.rounding();
        reach *= reach;
        var time:Number = 0;
        for (var step:int = 0; step < Newton.MOST_STEPS; step++)
        {
            x = px + time * dx;
            x = x > halfX ? x - halfX : (x < -halfX ? x + halfX : 0);
            y = py + time * dy;
            y = y > halfY ? y - halfY : (y < -halfY ? y + halfY : 0);
            z = pz + time * dz;
            z = z > halfZ ? z - halfZ : (z < -halfZ ? z + halfZ : 0);
            var squared:Number = x * x + y * y + z * z;
            var closing:Number = -(x * dx + y * dy + z * dz);
            if (squared <= reach)
            {
                return Newton.lastStep(time, squared, reach, radius, closing);
            }
            var next:Number = Newton.next(time, squared, radius, closing);
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
