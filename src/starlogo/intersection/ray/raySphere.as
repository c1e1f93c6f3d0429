package starlogo.intersection.ray
{
    import flash.geom.Vector3D;
    import starlogo.bounding.Sphere;

    /**
     * Finds where a ray enters a sphere. Touching counts, to within <code>ray.touchingFactor</code>. The distance of the centre is computed
     * perpendicular to the line, so that no digits cancel. Allocates nothing.
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
        out.begin(ray);
        if (closest - half > ray.from)
        {
            out.distance = closest - half;
            if (sphere.radius > 0)
            {
                x = ray.x + out.distance * ray.directionX - center.x;
                y = ray.y + out.distance * ray.directionY - center.y;
                z = ray.z + out.distance * ray.directionZ - center.z;
                out.setOutwards(x, y, z);
            }
        }
        return out.distance <= closest + half && out.distance <= ray.to;
    }
}
