package starlogo.intersection.ray
{
    import flash.geom.Vector3D;

    /**
     * Finds where a ray's line enters a ball, or where it leaves the ball.
     *
     * @param side -1 for where the line enters, 1 for where it leaves
     * @param out receives the distance
     * @return whether the line meets the ball
     *
     * @private
     */
    internal function crossBall(ray:Ray, center:Vector3D, radius:Number, side:int, out:RayEntry):Boolean
    {
        var x:Number = center.x - ray.x;
        var y:Number = center.y - ray.y;
        var z:Number = center.z - ray.z;
        // the middle of the line's part in the ball
        var closest:Number = x * ray.directionX + y * ray.directionY + z * ray.directionZ;
        // the vector from there to the ball's middle is perpendicular to the line, so no digits cancel
        x -= closest * ray.directionX;
        y -= closest * ray.directionY;
        z -= closest * ray.directionZ;
        var halfSquared:Number = radius * radius - (x * x + y * y + z * z);
        if (!(halfSquared >= 0))
        {
            return false;
        }
        out.distance = closest + side * Math.sqrt(halfSquared);
        return true;
    }
}
