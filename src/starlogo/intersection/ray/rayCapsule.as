package starlogo.intersection.ray
{
    import flash.geom.Vector3D;
    import starlogo.bounding.Capsule;
    import starlogo.geometry.Tolerances;

    /**
     * Narrows a ray to the part inside of a capsule: two balls, and the cylinder between them. Touching counts, to
     * within Tolerances.TOUCHING. Allocates nothing.
     *
     * <p>The steps are: widen the part by the two balls; project the line across the segment, where the cylinder is a circle; find where
     * the line enters and leaves the circle between the ends of the segment; find the normal from the nearest point of the segment.</p>
     *
     * @param ray in the space of the capsule; its part is narrowed, and its normal is set if it enters the capsule
     * @param capsule the radius and the length may be 0
     * @return whether the ray meets the capsule
     * @private
     */
    public function rayCapsule(ray:Ray, capsule:Capsule):Boolean
    {
        var start:Vector3D = capsule.start;
        var end:Vector3D = capsule.end;
        var radius:Number = capsule.radius * Tolerances.TOUCHING;
        ray.near = Infinity;
        ray.far = -Infinity;
        ray.addBall(start, radius);
        ray.addBall(end, radius);
        var axisX:Number = end.x - start.x;
        var axisY:Number = end.y - start.y;
        var axisZ:Number = end.z - start.z;
        var squared:Number = axisX * axisX + axisY * axisY + axisZ * axisZ;
        var x:Number = ray.x - start.x;
        var y:Number = ray.y - start.y;
        var z:Number = ray.z - start.z;
        if (squared > 0)
        {
            // As shares of the segment: the place of the line's point, and how far the line goes along the segment in a length of 1.
            var share:Number = (x * axisX + y * axisY + z * axisZ) / squared;
            var speed:Number = (ray.directionX * axisX + ray.directionY * axisY + ray.directionZ * axisZ) / squared;
            var acrossX:Number = ray.directionX - speed * axisX;
            var acrossY:Number = ray.directionY - speed * axisY;
            var acrossZ:Number = ray.directionZ - speed * axisZ;
            var turn:Number = acrossX * acrossX + acrossY * acrossY + acrossZ * acrossZ;
            if (turn > Tolerances.PARALLEL)
            {
                var asideX:Number = x - share * axisX;
                var asideY:Number = y - share * axisY;
                var asideZ:Number = z - share * axisZ;
                var closest:Number = -(asideX * acrossX + asideY * acrossY + asideZ * acrossZ) / turn;
                asideX += closest * acrossX;
                asideY += closest * acrossY;
                asideZ += closest * acrossZ;
                var inside:Number = radius * radius - (asideX * asideX + asideY * asideY + asideZ * asideZ);
                if (inside >= 0)
                {
                    inside = Math.sqrt(inside / turn);
                    var into:Number = closest - inside;
                    var out:Number = closest + inside;
                    if (speed != 0)
                    {
                        var first:Number = speed > 0 ? -share : 1 - share;
                        var last:Number = speed > 0 ? 1 - share : -share;
                        first /= speed;
                        last /= speed;
                        into = first > into ? first : into;
                        out = last < out ? last : out;
                    }
                    else if (share < 0 || share > 1)
                    {
                        out = -Infinity;
                    }
                    if (into <= out)
                    {
                        ray.near = into < ray.near ? into : ray.near;
                        ray.far = out > ray.far ? out : ray.far;
                    }
                }
            }
        }
        var at:Number = ray.near;
        if (at > ray.from && at < Infinity)
        {
            x += at * ray.directionX;
            y += at * ray.directionY;
            z += at * ray.directionZ;
            include "../../geometry/pointToSegment.inc";
            var length:Number = Math.sqrt(x * x + y * y + z * z);
            if (length > 0 && capsule.radius > 0)
            {
                ray.normalX = x / length;
                ray.normalY = y / length;
                ray.normalZ = z / length;
            }
        }
        return ray.narrow();
    }
}
