package starlogo.intersection.ray
{
    import flash.geom.Vector3D;
    import starlogo.bounding.Hull;
    import starlogo.engine;

    use namespace engine;

    /**
     * Finds where a ray enters a hull: where it is inside of all its half-spaces. Touching counts, to within <code>ray.touchingFactor</code> of a
     * plane's distance from the centre, but the place is on the hull itself, unless the line only touches. Allocates nothing, except at the first
     * ray that meets the hull where it is.
     *
     * @param ray in the space of the hull
     * @param hull may be flat
     * @param out receives the distance and the normal
     * @return whether the ray meets the hull
     * @private
     */
    public function rayHull(ray:Ray, hull:Hull, out:RayEntry):Boolean
    {
        var center:Vector3D = hull.center;
        var x:Number = ray.x - center.x;
        var y:Number = ray.y - center.y;
        var z:Number = ray.z - center.z;
        var planes:Vector.<Number> = hull.halfSpaces;
        var end:int = planes.length;
        var entered:int = -1;
        // where the line is inside of the hull or touches it, and where it enters the hull itself
        var near:Number = -Infinity;
        var far:Number = ray.to;
        var exact:Number = -Infinity;
        for (var i:int = 0; i < end; i += 4)
        {
            var height:Number = planes[i] * x + planes[int(i + 1)] * y + planes[int(i + 2)] * z - planes[int(i + 3)] - hull.radius;
            var speed:Number = planes[i] * ray.directionX + planes[int(i + 1)] * ray.directionY + planes[int(i + 2)] * ray.directionZ;
            if (speed < 0 && -height / speed > exact)
            {
                exact = -height / speed;
            }
            height -= (ray.touchingFactor - 1) * planes[int(i + 3)];
            if (speed < 0 && -height / speed > near)
            {
                near = -height / speed;
                entered = i;
            }
            else if (speed > 0 && -height / speed < far)
            {
                far = -height / speed;
            }
            else if (speed == 0 && height > 0)
            {
                far = -Infinity;
            }
        }
        out.begin(ray);
        if (near > ray.from)
        {
            out.distance = exact > near && exact <= far ? exact : near;
            out.setNormal(ray, planes[entered], planes[int(entered + 1)], planes[int(entered + 2)]);
        }
        return out.distance <= far;
    }
}
