package starlogo.intersection.ray
{
    import flash.geom.Vector3D;
    import starlogo.bounding.Sphere;

    /**
     * Narrows a ray to the part inside of a sphere. Touching counts, to within <code>ray.touchingFactor</code>. The distance of the centre is computed
     * perpendicular to the line, so that no digits cancel. Allocates nothing.
     *
     * @param ray in the space of the sphere; its part is narrowed, and its normal is set if it enters the sphere
     * @param sphere a radius of 0 makes it a point
     * @return whether the ray meets the sphere
     * @private
     */
    public function raySphere(ray:Ray, sphere:Sphere):Boolean
    {
        var center:Vector3D = sphere.center;
        ray.near = Infinity;
        ray.far = -Infinity;
        ray.addBall(center, sphere.radius * ray.touchingFactor);
        var at:Number = ray.near;
        if (at > ray.from && at < Infinity && sphere.radius > 0)
        {
            var x:Number = ray.x + at * ray.directionX - center.x;
            var y:Number = ray.y + at * ray.directionY - center.y;
            var z:Number = ray.z + at * ray.directionZ - center.z;
            var length:Number = Math.sqrt(x * x + y * y + z * z);
            ray.normalX = x / length;
            ray.normalY = y / length;
            ray.normalZ = z / length;
        }
        return ray.narrow();
    }
}
