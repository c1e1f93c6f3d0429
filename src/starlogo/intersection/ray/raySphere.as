package starlogo.intersection.ray
{
    import flash.geom.Vector3D;
    import starlogo.bounding.Sphere;

    /**
     * Finds where a ray enters a sphere. Touching counts, to within <code>ray.touchingFactor</code>. Allocates nothing.
     *
     * @param ray in the space of the sphere
     * @param sphere a radius of 0 makes it a point
     * @param out receives the distance and the normal
     * @return whether the ray meets the sphere
     * @private
     */
    public function raySphere(ray:Ray, sphere:Sphere, out:RayEntry):Boolean
    {
        var center:Vector3D = sphere.center;
        var radius:Number = sphere.radius * ray.touchingFactor;
        var x:Number = center.x - ray.x;
        var y:Number = center.y - ray.y;
        var z:Number = center.z - ray.z;
        include "lineThroughBall.inc";
        if (!(halfSquared >= 0))
        {
            return false;
        }
        var half:Number = Math.sqrt(halfSquared);
        var near:Number = closest - half;
        out.begin(ray);
        if (near > ray.from)
        {
            out.distance = near;
            if (sphere.radius > 0)
            {
                out.setOutwards(ray.x + near * ray.directionX - center.x, ray.y + near * ray.directionY - center.y, ray.z + near * ray.directionZ - center.z);
            }
        }
        else if (!(ray.from <= closest + half))
        {
            // it begins beyond the sphere
            return false;
        }
        return out.distance <= ray.to;
    }
}
