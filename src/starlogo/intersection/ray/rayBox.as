package starlogo.intersection.ray
{
    import flash.geom.Vector3D;
    import starlogo.bounding.Box;

    /**
     * Narrows a ray to what is inside of a box: between its three pairs of faces (Kay and Kajiya, "Ray tracing complex scenes", SIGGRAPH 1986).
     * Its surface counts. Allocates nothing.
     *
     * @param ray in the space of the box; its part is narrowed, and its normal set if it enters
     * @param box half-extents may be 0
     * @return whether the ray meets the box
     *
     * @private
     */
    public function rayBox(ray:Ray, box:Box):Boolean
    {
        var center:Vector3D = box.center;
        var x:Number = ray.x - center.x;
        var y:Number = ray.y - center.y;
        var z:Number = ray.z - center.z;
        ray.near = -Infinity;
        ray.far = Infinity;
        var axis:Vector3D = box.axisX;
        var along:Number = axis.x * ray.directionX + axis.y * ray.directionY + axis.z * ray.directionZ;
        var entered:Vector3D = null;
        var speed:Number = 0;
        if (ray.cut(axis.x * x + axis.y * y + axis.z * z, along, box.halfX))
        {
            entered = axis;
            speed = along;
        }
        axis = box.axisY;
        along = axis.x * ray.directionX + axis.y * ray.directionY + axis.z * ray.directionZ;
        if (ray.cut(axis.x * x + axis.y * y + axis.z * z, along, box.halfY))
        {
            entered = axis;
            speed = along;
        }
        axis = box.axisZ;
        along = axis.x * ray.directionX + axis.y * ray.directionY + axis.z * ray.directionZ;
        if (ray.cut(axis.x * x + axis.y * y + axis.z * z, along, box.halfZ))
        {
            entered = axis;
            speed = along;
        }
        if (ray.near > ray.from)
        {
            var side:Number = speed > 0 ? -1 : 1;
            ray.normalX = side * entered.x;
            ray.normalY = side * entered.y;
            ray.normalZ = side * entered.z;
        }
        return ray.narrow();
    }
}
