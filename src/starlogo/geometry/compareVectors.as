package starlogo.geometry
{
    import flash.geom.Vector3D;

    /**
     * The order of two vectors by x, then by y, then by z: less than 0 if the first comes before the second, more than 0 if it comes after it, 0 if they
     * are equal. No coordinate may be NaN. A test that gives the same answer for (a, b) and (b, a), rounding included, puts its arguments in this order.
     *
     * @private
     */
    public function compareVectors(a:Vector3D, b:Vector3D):int
    {
        var order:Number = a.x != b.x ? a.x - b.x : a.y != b.y ? a.y - b.y : a.z - b.z;
        return order < 0 ? -1 : order > 0 ? 1 : 0;
    }
}
