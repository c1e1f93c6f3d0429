package starlogo.intersection
{
    import flash.geom.Vector3D;

    /**
     * Whether a comes after b in y, or where these are equal in z: what settles the order of two structures whose x is
     * the same. A test that always works in one order gives the same answer, rounding included, for both.
     *
     * @private
     */
    internal function isAfter(a:Vector3D, b:Vector3D):Boolean
    {
        var aY:Number = a.y;
        var bY:Number = b.y;
        return aY > bY || (aY == bY && a.z > b.z);
    }
}
