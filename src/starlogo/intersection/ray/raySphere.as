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
        if (!crossBall(ray, center, radius, -1, out))
        {
            return false;
        }
        var near:Number = out.distance;
        if (near <= ray.from)
        {
            // the ray begins inside of the sphere, or beyond it
            crossBall(ray, center, radius, 1, out);
            var far:Number = out.distance;
            out.begin(ray);
            return ray.from <= far && ray.from <= ray.to;
        }
        out.begin(ray);
        out.distance = near;
        if (sphere.radius > 0)
        {
            out.setOutwards(ray.x + near * ray.directionX - center.x, ray.y + near * ray.directionY - center.y, ray.z + near * ray.directionZ - center.z);
        }
        return near <= ray.to;
    }
}
