package starlogo.intersection.ray
{
    import flash.geom.Vector3D;
    import starlogo.bounding.Capsule;
    import starlogo.geometry.Tolerances;

    /**
     * Finds where a ray's line enters a capsule, or where it leaves the capsule. That place is on the infinite cylinder around the axis or, where the
     * cylinder is beyond an end of the axis, on the ball around that end. Distances are computed perpendicular to the line and to the axis, so that no
     * digits cancel.
     *
     * @param radius takes the place of the capsule's
     * @param side -1 for where the line enters, 1 for where it leaves
     * @param out receives the distance
     * @return whether the line meets the capsule
     *
     * @private
     */
    internal function crossCapsule(ray:Ray, capsule:Capsule, radius:Number, side:int, out:RayEntry):Boolean
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
        var distance:Number = side * Infinity;
        if (acrossSquared > Tolerances.PARALLEL)
        {
            x -= share * axisX;
            y -= share * axisY;
            z -= share * axisZ;
            var closest:Number = -(x * acrossX + y * acrossY + z * acrossZ) / acrossSquared;
            x += closest * acrossX;
            y += closest * acrossY;
            z += closest * acrossZ;
            var halfSquared:Number = radius * radius - (x * x + y * y + z * z);
            if (!(halfSquared >= 0))
            {
                return false;
            }
            distance = closest + side * Math.sqrt(halfSquared / acrossSquared);
        }
        var place:Number = share + distance * speed;
        if (!(place >= 0 && place <= 1))
        {
            return crossBall(ray, place > 1 ? end : start, radius, side, out);
        }
        out.distance = distance;
        return true;
    }
}
