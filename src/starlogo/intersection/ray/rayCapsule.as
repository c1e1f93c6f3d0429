package starlogo.intersection.ray
{
    import flash.geom.Vector3D;
    import starlogo.bounding.Capsule;

    /**
     * Narrows a ray to the part inside of a capsule: two balls, and the cylinder between them. Touching counts, to
     * within <code>ray.touchingFactor</code>. Allocates nothing.
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
        var radius:Number = capsule.radius * ray.touchingFactor;
        ray.near = Infinity;
        ray.far = -Infinity;
        ray.addBall(start, radius);
        ray.addBall(end, radius);
        ray.addTube(start, end, radius);
        var at:Number = ray.near;
        if (at > ray.from && at < Infinity)
        {
            // the normal points away from the nearest point of the segment
            var axisX:Number = end.x - start.x;
            var axisY:Number = end.y - start.y;
            var axisZ:Number = end.z - start.z;
            var x:Number = ray.x - start.x + at * ray.directionX;
            var y:Number = ray.y - start.y + at * ray.directionY;
            var z:Number = ray.z - start.z + at * ray.directionZ;
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
