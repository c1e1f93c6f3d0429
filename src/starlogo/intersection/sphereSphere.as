package starlogo.intersection
{
    import flash.geom.Vector3D;
    import starlogo.bounding.Sphere;

    /**
     * Whether two spheres touch or overlap: compares the squared distance of their centres with the square of the sum of their radii
     * (thesis §3.6.2). Touching counts, exactly as the numbers are stored: there is no Tolerances.TOUCHING here. Allocates nothing.
     *
     * @param a in the space of b; a radius of 0 makes it a point
     * @param b in the space of a; a radius of 0 makes it a point
     */
    public function sphereSphere(a:Sphere, b:Sphere):Boolean
    {
        var centerA:Vector3D = a.center;
        var centerB:Vector3D = b.center;
        var x:Number = centerA.x - centerB.x;
        var y:Number = centerA.y - centerB.y;
        var z:Number = centerA.z - centerB.z;
        var touchingDistance:Number = a.radius + b.radius;
        return x * x + y * y + z * z <= touchingDistance * touchingDistance;
    }
}
