package starlogo.intersection
{
    import flash.geom.Vector3D;

    /**
     * Whether a place comes after another one: by x, then by y, then by z. A symmetric test puts its arguments in this order, so that it gives the
     * same answer for (a, b) and (b, a), rounding included.
     *
     * @private
     */
    public function isAfter(a:Vector3D, b:Vector3D):Boolean
    {
        var aX:Number = a.x;
        var bX:Number = b.x;
        return aX > bX || aX == bX && (a.y > b.y || a.y == b.y && a.z > b.z);
    }
}
