package starlogo.intersection.ray
{
    import flash.geom.Vector3D;
    import starlogo.bounding.Capsule;
    import starlogo.geometry.Tolerances;

    /**
     * Finds where a ray's line enters and leaves a capsule: the infinite cylinder around the axis or, where that is beyond an end of the axis, the ball
     * around that end. Distances are computed perpendicular to the line and to the axis, so that no digits cancel.
     *
     * @param radius takes the place of the capsule's
     * @param out receives both distances
     * @return whether the line meets the capsule
     *
     * @private
     */
    internal function crossCapsule(ray:Ray, capsule:Capsule, radius:Number, out:RayEntry):Boolean
    {
        var start:Vector3D = capsule.start;
        var end:Vector3D = capsule.end;
        var axisX:Number = end.x - start.x;
        var axisY:Number = end.y - start.y;
        var axisZ:Number = end.z - start.z;
        var squared:Number = axisX * axisX + axisY * axisY + axisZ * axisZ;
        var x:Number = ray.x - start.x;
        var y:Number = ray.y - start.y;
        var z:Number = ray.z - start.z;
        // As shares of the axis: the place of the line's point, and how far the line goes along the axis in a length of 1. What is left is across it.
        var share:Number = squared > 0 ? (x * axisX + y * axisY + z * axisZ) / squared : 0;
        var speed:Number = squared > 0 ? (ray.directionX * axisX + ray.directionY * axisY + ray.directionZ * axisZ) / squared : 0;
        var acrossX:Number = ray.directionX - speed * axisX;
        var acrossY:Number = ray.directionY - speed * axisY;
        var acrossZ:Number = ray.directionZ - speed * axisZ;
        var acrossSquared:Number = acrossX * acrossX + acrossY * acrossY + acrossZ * acrossZ;
        var near:Number = -Infinity;
        var far:Number = Infinity;
        if (acrossSquared > Tolerances.PARALLEL)
        {
            x -= share * axisX;
            y -= share * axisY;
            z -= share * axisZ;
            var closest:Number = -(x * acrossX + y * acrossY + z * acrossZ) / acrossSquared;
            x += closest * acrossX;
            y += closest * acrossY;
            z += closest * acrossZ;
            var half:Number = radius * radius - (x * x + y * y + z * z);
            if (!(half >= 0))
            {
                return false;
            }
            half = Math.sqrt(half / acrossSquared);
            near = closest - half;
            far = closest + half;
        }
        var atNear:Number = share + near * speed;
        if (!(atNear >= 0 && atNear <= 1))
        {
            if (!crossBall(ray, atNear > 1 ? end : start, radius, out))
            {
                return false;
            }
            near = out.distance;
        }
        var atFar:Number = share + far * speed;
        if (!(atFar >= 0 && atFar <= 1))
        {
            if (!crossBall(ray, atFar > 1 ? end : start, radius, out))
            {
                return false;
            }
            far = out.end;
        }
        out.distance = near;
        out.end = far;
        return true;
    }
}
