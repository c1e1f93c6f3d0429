package starlogo.convex
{
    import flash.geom.Vector3D;
    import starlogo.geometry.Tolerances;

    /**
     * Replaces a direction by a unit vector perpendicular to it that points upwards as far as possible. If the direction is vertical, up to
     * Tolerances.UPRIGHT, the vector is along x. If it is 0, the vector is along z.
     *
     * @private
     */
    internal function turnUpwards(along:Vector3D):void
    {
        var x:Number = along.x;
        var y:Number = along.y;
        var z:Number = along.z;
        var squared:Number = x * x + y * y + z * z;
        if (!(squared > 0))
        {
            along.setTo(0, 0, 1);
            return;
        }
        if (x * x + y * y > Tolerances.UPRIGHT * squared)
        {
            along.setTo(-x * z / squared, -y * z / squared, 1 - z * z / squared);
        }
        else
        {
            along.setTo(1 - x * x / squared, -x * y / squared, -x * z / squared);
        }
        var length:Number = Math.sqrt(along.x * along.x + along.y * along.y + along.z * along.z);
        along.x /= length;
        along.y /= length;
        along.z /= length;
    }
}
