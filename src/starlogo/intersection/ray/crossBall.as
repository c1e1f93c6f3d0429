package starlogo.intersection.ray
{
    import flash.geom.Vector3D;

    /**
     * Finds where a ray's line enters and leaves a ball. The distance of the centre is computed perpendicular to the line, so that no digits cancel.
     *
     * @param out receives both distances
     * @return whether the line meets the ball
     *
     * @private
     */
    internal function crossBall(ray:Ray, center:Vector3D, radius:Number, out:RayEntry):Boolean
    {
        var x:Number = center.x - ray.x;
        var y:Number = center.y - ray.y;
        var z:Number = center.z - ray.z;
        var closest:Number = x * ray.directionX + y * ray.directionY + z * ray.directionZ;
        x -= closest * ray.directionX;
        y -= closest * ray.directionY;
        z -= closest * ray.directionZ;
        var half:Number = radius * radius - (x * x + y * y + z * z);
        if (!(half >= 0))
        {
            return false;
        }
        half = Math.sqrt(half);
        out.distance = closest - half;
        out.end = closest + half;
        return true;
    }
}
