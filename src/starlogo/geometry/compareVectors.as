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
        if (a.x != b.x)
        {
            return a.x < b.x ? -1 : 1;
        }
        if (a.y != b.y)
        {
            return a.y < b.y ? -1 : 1;
        }
        if (a.z != b.z)
        {
            return a.z < b.z ? -1 : 1;
        }
        return 0;
    }
}
