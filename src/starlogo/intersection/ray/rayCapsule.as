package starlogo.intersection.ray
{
    import flash.geom.Vector3D;
    import starlogo.bounding.Capsule;
    import starlogo.geometry.Tolerances;

    /**
     * Finds where a ray enters a capsule. The line enters and leaves the infinite cylinder around the axis. Where that is beyond an end of the axis,
     * it enters or leaves the ball around that end instead. Touching counts, to within <code>ray.touchingFactor</code>. Distances are computed
     * perpendicular to the line and to the axis, so that no digits cancel. Allocates nothing.
     *
     * @param ray in the space of the capsule
     * @param capsule the radius and the length may be 0
     * @param out receives the distance and the normal
     * @return whether the ray meets the capsule
     * @private
     */
    public function rayCapsule(ray:Ray, capsule:Capsule, out:RayEntry):Boolean
    {
        var start:Vector3D = capsule.start;
        var end:Vector3D = capsule.end;
        var radius:Number = capsule.radius * ray.touchingFactor;
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
        var turn:Number = acrossX * acrossX + acrossY * acrossY + acrossZ * acrossZ;
        var near:Number = -Infinity;
        var far:Number = Infinity;
        var half:Number;
        if (turn > Tolerances.PARALLEL)
        {
            x -= share * axisX;
            y -= share * axisY;
            z -= share * axisZ;
            var closest:Number = -(x * acrossX + y * acrossY + z * acrossZ) / turn;
            x += closest * acrossX;
            y += closest * acrossY;
            z += closest * acrossZ;
            half = radius * radius - (x * x + y * y + z * z);
            if (!(half >= 0))
            {
                return false;
            }
            half = Math.sqrt(half / turn);
            near = closest - half;
            far = closest + half;
        }
        for (var side:int = -1; side < 2; side += 2)
        {
            var place:Number = side < 0 ? near : far;
            var at:Number = share + place * speed;
            if (!(at >= 0 && at <= 1))
            {
                var ball:Vector3D = at > 1 ? end : start;
                x = ball.x - ray.x;
                y = ball.y - ray.y;
                z = ball.z - ray.z;
                place = x * ray.directionX + y * ray.directionY + z * ray.directionZ;
                x -= place * ray.directionX;
                y -= place * ray.directionY;
                z -= place * ray.directionZ;
                half = radius * radius - (x * x + y * y + z * z);
                if (!(half >= 0))
                {
                    return false;
                }
                place += side * Math.sqrt(half);
                near = side < 0 ? place : near;
                far = side < 0 ? far : place;
            }
        }
        out.begin(ray);
        if (near > ray.from)
        {
            out.distance = near;
            // the normal points away from the nearest point of the axis
            x = ray.x - start.x + near * ray.directionX;
            y = ray.y - start.y + near * ray.directionY;
            z = ray.z - start.z + near * ray.directionZ;
            include "../../geometry/pointToSegment.inc";
            if (capsule.radius > 0)
            {
                out.setOutwards(x, y, z);
            }
        }
        return out.distance <= far && out.distance <= ray.to;
    }
}
