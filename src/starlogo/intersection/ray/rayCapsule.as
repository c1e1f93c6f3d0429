package starlogo.intersection.ray
{
    import flash.geom.Vector3D;
    import starlogo.bounding.Capsule;

    /**
     * Finds where a ray enters a capsule. Touching counts, to within <code>ray.touchingFactor</code>. Allocates nothing.
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
        if (!crossCapsule(ray, capsule, radius, -1, out))
        {
            return false;
        }
        var near:Number = out.distance;
        // a ray that does not begin before it enters begins inside of the capsule or beyond it
        if (!(near > ray.from) && !(crossCapsule(ray, capsule, radius, 1, out) && ray.from <= out.distance))
        {
            return false;
        }
        out.begin(ray);
        if (near > ray.from)
        {
            out.distance = near;
            if (capsule.radius > 0)
            {
                // the normal points away from the nearest point of the axis
                var start:Vector3D = capsule.start;
                var end:Vector3D = capsule.end;
                var axisX:Number = end.x - start.x;
                var axisY:Number = end.y - start.y;
                var axisZ:Number = end.z - start.z;
                var x:Number = ray.x - start.x + near * ray.directionX;
                var y:Number = ray.y - start.y + near * ray.directionY;
                var z:Number = ray.z - start.z + near * ray.directionZ;
                include "../../geometry/pointToSegment.inc";
                out.setOutwards(x, y, z);
            }
        }
        return out.distance <= ray.to;
    }
}
