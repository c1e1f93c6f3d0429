package starlogo.intersection.ray
{
    import flash.geom.Vector3D;
    import starlogo.bounding.Hull;
    import starlogo.engine;

    use namespace engine;

    /**
     * Narrows a ray to the part inside of a hull, which is the part inside of all its half-spaces. Touching counts, to within
     * <code>ray.touchingFactor</code> of a plane's distance from the centre. Allocates nothing, except at the first ray that meets the hull where it is.
     *
     * @param ray in the space of the hull; its part is narrowed, and its normal is set if it enters the hull
     * @param hull may be flat
     * @return whether the ray meets the hull
     * @private
     */
    public function rayHull(ray:Ray, hull:Hull):Boolean
    {
        var center:Vector3D = hull.center;
        var x:Number = ray.x - center.x;
        var y:Number = ray.y - center.y;
        var z:Number = ray.z - center.z;
        var planes:Vector.<Number> = hull.halfSpaces;
        var end:int = planes.length;
        var entered:int = -1;
        ray.near = ray.entry = -Infinity;
        ray.far = Infinity;
        for (var i:int = 0; i < end; i += 4)
        {
            var height:Number = planes[i] * x + planes[int(i + 1)] * y + planes[int(i + 2)] * z - planes[int(i + 3)] - hull.radius;
            var speed:Number = planes[i] * ray.directionX + planes[int(i + 1)] * ray.directionY + planes[int(i + 2)] * ray.directionZ;
            if (speed < 0 && -height / speed > ray.entry)
            {
                ray.entry = -height / speed;
            }
            height -= (ray.touchingFactor - 1) * planes[int(i + 3)];
            if (speed < 0 && -height / speed > ray.near)
            {
                ray.near = -height / speed;
                entered = i;
            }
            else if (speed > 0 && -height / speed < ray.far)
            {
                ray.far = -height / speed;
            }
            else if (speed == 0 && height > 0)
            {
                ray.far = -Infinity;
            }
        }
        if (ray.near > ray.from)
        {
            ray.setNormal(planes[entered], planes[int(entered + 1)], planes[int(entered + 2)]);
        }
        return ray.narrowExactly();
    }
}
