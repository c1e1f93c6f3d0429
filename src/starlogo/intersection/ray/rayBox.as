package starlogo.intersection.ray
{
    import flash.geom.Vector3D;
    import starlogo.bounding.Box;

    /**
     * Finds where a ray enters a box: where it is between all three pairs of faces (Kay and Kajiya, "Ray tracing complex scenes", SIGGRAPH 1986).
     * Touching counts, to within <code>ray.touchingFactor</code>, but the place is on the box itself, unless the line only touches. Allocates
     * nothing.
     *
     * @param ray in the space of the box
     * @param box half-extents may be 0
     * @param out receives the distance and the normal
     * @return whether the ray meets the box
     * @private
     */
    public function rayBox(ray:Ray, box:Box, out:RayEntry):Boolean
    {
        var middle:Vector3D = box.center;
        var entered:Vector3D = null;
        // where the line is inside of the box or touches it, and where it enters the box itself
        var near:Number = -Infinity;
        var far:Number = Infinity;
        var exact:Number = -Infinity;
        for (var i:int = 0; i < 3; i++)
        {
            var axis:Vector3D = i == 0 ? box.axisX : i == 1 ? box.axisY : box.axisZ;
            var half:Number = i == 0 ? box.halfX : i == 1 ? box.halfY : box.halfZ;
            var offset:Number = axis.x * (ray.x - middle.x) + axis.y * (ray.y - middle.y) + axis.z * (ray.z - middle.z);
            var speed:Number = axis.x * ray.directionX + axis.y * ray.directionY + axis.z * ray.directionZ;
            // a line within the planes crosses them at an infinite distance, if its speed is not -0
            speed = speed == 0 ? 0 : speed;
            var ahead:Number = speed < 0 ? -half : half;
            var place:Number = (-ahead - offset) / speed;
            exact = place > exact && place < Infinity ? place : exact;
            ahead *= ray.touchingFactor;
            place = (ahead - offset) / speed;
            far = place < far ? place : far;
            place = (-ahead - offset) / speed;
            if (place > near)
            {
                near = place;
                entered = axis;
            }
        }
        far = far < ray.to ? far : ray.to;
        out.begin(ray);
        if (near > ray.from)
        {
            out.distance = exact > near && exact <= far ? exact : near;
            out.setNormal(ray, entered.x, entered.y, entered.z);
        }
        return out.distance <= far;
    }
}
