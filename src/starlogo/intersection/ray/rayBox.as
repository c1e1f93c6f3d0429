package starlogo.intersection.ray
{
    import flash.geom.Vector3D;
    import starlogo.bounding.Box;

    /**
     * Narrows a ray to the part inside of a box, which is the part between its three pairs of faces (Kay and Kajiya, "Ray tracing complex
     * scenes", SIGGRAPH 1986). The box's surface counts as inside. Allocates nothing.
     *
     * @param ray in the space of the box; its part is narrowed, and its normal is set if it enters the box
     * @param box half-extents may be 0
     * @return whether the ray meets the box
     * @private
     */
    public function rayBox(ray:Ray, box:Box):Boolean
    {
        var center:Vector3D = box.center;
        var x:Number = ray.x - center.x;
        var y:Number = ray.y - center.y;
        var z:Number = ray.z - center.z;
        ray.beginWhole();
        var entered:Vector3D = null;
        var axis:Vector3D = box.axisX;
        ray.offset = axis.x * x + axis.y * y + axis.z * z;
        ray.speed = axis.x * ray.directionX + axis.y * ray.directionY + axis.z * ray.directionZ;
        ray.half = box.halfX;
        if (ray.cut())
        {
            entered = axis;
        }
        axis = box.axisY;
        ray.offset = axis.x * x + axis.y * y + axis.z * z;
        ray.speed = axis.x * ray.directionX + axis.y * ray.directionY + axis.z * ray.directionZ;
        ray.half = box.halfY;
        if (ray.cut())
        {
            entered = axis;
        }
        axis = box.axisZ;
        ray.offset = axis.x * x + axis.y * y + axis.z * z;
        ray.speed = axis.x * ray.directionX + axis.y * ray.directionY + axis.z * ray.directionZ;
        ray.half = box.halfZ;
        if (ray.cut())
        {
            entered = axis;
        }
        if (ray.near > ray.from)
        {
            ray.normalX = entered.x;
            ray.normalY = entered.y;
            ray.normalZ = entered.z;
            ray.turnNormal();
        }
        return ray.narrow();
    }
}
