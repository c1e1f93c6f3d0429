package starlogo.intersection.ray
{
    import flash.geom.Vector3D;
    import starlogo.bounding.Capsule;
    import starlogo.geometry.Tolerances;

    /**
     * Finds where a ray enters a capsule. Touching counts, to within <code>ray.touchingFactor</code>. Allocates nothing.
     *
     * <p>A line enters and leaves the capsule on the infinite cylinder around the axis or, where the cylinder is beyond an end of the axis, on the ball
     * around that end. Distances are computed perpendicular to the line and to the axis, so that no digits cancel.</p>
     *
     * @param ray in the space of the capsule
     * @param capsule the radius and the length may be 0
     * @param out receives the distance and the normal
     * @return whether the ray meets the capsule
     * @private
     */
    public function rayCapsule(ray:Ray, capsule:Capsule, out:RayEntry):Boolean
    {
        var radius:Number = capsule.radius * ray.touchingFactor;
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
        // where the line enters and leaves the cylinder
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
            var halfSquared:Number = radius * radius - (x * x + y * y + z * z);
            if (!(halfSquared >= 0))
            {
                return false;
            }
            var half:Number = Math.sqrt(halfSquared / acrossSquared);
            near = closest - half;
            far = closest + half;
        }
        var place:Number = share + near * speed;
        if (!(place >= 0 && place <= 1))
        {
            if (!crossBall(ray, place > 1 ? end : start, radius, -1, out))
            {
                return false;
            }
            near = out.distance;
        }
        if (!(near > ray.from))
        {
            // the ray begins inside of the capsule or beyond it
            place = share + far * speed;
            if (!(place >= 0 && place <= 1))
            {
                if (!crossBall(ray, place > 1 ? end : start, radius, 1, out))
                {
                    return false;
                }
                far = out.distance;
            }
            out.begin(ray);
            return ray.from <= far && ray.from <= ray.to;
        }
        out.begin(ray);
        out.distance = near;
        if (capsule.radius > 0)
        {
            // the normal points away from the nearest point of the axis
            x = ray.x - start.x + near * ray.directionX;
            y = ray.y - start.y + near * ray.directionY;
            z = ray.z - start.z + near * ray.directionZ;
            include "../../geometry/pointToSegment.inc";
            out.setOutwards(x, y, z);
        }
        return near <= ray.to;
    }
}
