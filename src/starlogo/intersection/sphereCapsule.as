package starlogo.intersection
{
    import flash.geom.Vector3D;
    import starlogo.bounding.Capsule;
    import starlogo.bounding.Sphere;
    import starlogo.geometry.Tolerances;

    // This function repeats the arithmetic of RoundKernel, because a call through that takes about twice as long.
    // KernelsAgreeTest checks that both agree.

    /**
     * Whether a sphere and a capsule touch or overlap: compares the distance from the sphere's centre to the capsule's segment with the sum
     * of the radii (thesis §3.6.5; Ericson, "Real-Time Collision Detection", §5.1.2). Touching counts, to within Tolerances.TOUCHING.
     * Allocates nothing.
     *
     * @param sphere in the space of the capsule; a radius of 0 makes it a point
     * @param capsule in the space of the sphere; its length may be 0
     */
    public function sphereCapsule(sphere:Sphere, capsule:Capsule):Boolean
    {
        var start:Vector3D = capsule.start;
        var end:Vector3D = capsule.end;
        var center:Vector3D = sphere.center;
        var axisX:Number = end.x - start.x;
        var axisY:Number = end.y - start.y;
        var axisZ:Number = end.z - start.z;
        var x:Number = center.x - start.x;
        var y:Number = center.y - start.y;
        var z:Number = center.z - start.z;
        include "../geometry/pointToSegment.inc";
        var touchingDistance:Number = (sphere.radius + capsule.radius) * Tolerances.TOUCHING;
        return x * x + y * y + z * z <= touchingDistance * touchingDistance;
    }
}
