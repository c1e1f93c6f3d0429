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
        include "lineThroughBall.inc";
        if (!(halfSquared >= 0))
        {
            return false;
        }
        out.distance = closest + side * Math.sqrt(halfSquared);
        return true;
    }
}
