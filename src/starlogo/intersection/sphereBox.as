package starlogo.intersection
{
    import flash.geom.Vector3D;
    import starlogo.bounding.Box;
    import starlogo.bounding.Sphere;
    import starlogo.geometry.Tolerances;

    // This function repeats the arithmetic of RoundKernel, because a call through that takes about twice as long.
    // KernelsAgreeTest checks that both agree.

    /**
     * Whether a sphere and a box touch or overlap: compares the distance from the sphere's centre to the box with the radius. Touching
     * counts, to within Tolerances.TOUCHING. Allocates nothing.
     *
     * <p>The distance is found one dimension at a time, in the box's own axes (Arvo, "A simple method for box-sphere intersection testing",
     * Graphics Gems, 1990). The thesis (§3.6.6) adds the distances of the dimensions. Here their squares are added, because that is the
     * squared distance.</p>
     *
     * @param sphere in the space of the box; a radius of 0 makes it a point
     * @param box in the space of the sphere; half-extents may be 0
     */
    public function sphereBox(sphere:Sphere, box:Box):Boolean
    {
        var center:Vector3D = sphere.center;
        var boxCenter:Vector3D = box.center;
        var toX:Number = center.x - boxCenter.x;
        var toY:Number = center.y - boxCenter.y;
        var toZ:Number = center.z - boxCenter.z;
        var axis:Vector3D = box.axisX;
        var x:Number = axis.x * toX + axis.y * toY + axis.z * toZ;
        axis = box.axisY;
        var y:Number = axis.x * toX + axis.y * toY + axis.z * toZ;
        axis = box.axisZ;
        var z:Number = axis.x * toX + axis.y * toY + axis.z * toZ;
        var halfX:Number = box.halfX;
        var halfY:Number = box.halfY;
        var halfZ:Number = box.halfZ;
        include "../geometry/squaredToBox.inc";
        var touchingDistance:Number = sphere.radius * Tolerances.TOUCHING;
        return squaredDistance <= touchingDistance * touchingDistance;
    }
}
