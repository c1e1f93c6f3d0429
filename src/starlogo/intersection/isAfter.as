package starlogo.intersection
{
    import flash.geom.Vector3D;

    /**
     * Whether a comes after b by y, or by z if their y is equal. It settles the order of two structures with the same x. A test that always
     * takes its structures in one order gives the same answer for (a, b) and (b, a), rounding included.
     *
     * @private
     */
    public function isAfter(a:Vector3D, b:Vector3D):Boolean
    {
        var aY:Number = a.y;
        var bY:Number = b.y;
        return aY > bY || (aY == bY && a.z > b.z);
    }
}
