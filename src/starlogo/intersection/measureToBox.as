package starlogo.intersection
{
    import flash.geom.Vector3D;
    import starlogo.bounding.Box;
    import starlogo.convex.CoreGap;
    import starlogo.convex.RelativeMotion;

    /**
     * Replaces a place by the vector to it from the nearest point of a box.
     *
     * @param motion of the place
     * @param gap its vector is the place as seen from the box's middle, in the box's axes. Receives the vector in the box's space, its squared length,
     *     and how the motion closes it
     *
     * @private
     */
    internal function measureToBox(box:Box, motion:RelativeMotion, gap:RoundGap):void
    {
        var axisX:Vector3D = box.axisX;
        var axisY:Vector3D = box.axisY;
        var axisZ:Vector3D = box.axisZ;
        var vector:CoreGap = gap.cores;
        var x:Number = vector.x;
        var y:Number = vector.y;
        var z:Number = vector.z;
        x = x > box.halfX ? x - box.halfX : (x < -box.halfX ? x + box.halfX : 0);
        y = y > box.halfY ? y - box.halfY : (y < -box.halfY ? y + box.halfY : 0);
        z = z > box.halfZ ? z - box.halfZ : (z < -box.halfZ ? z + box.halfZ : 0);
        vector.x = x * axisX.x + y * axisY.x + z * axisZ.x;
        vector.y = x * axisX.y + y * axisY.y + z * axisZ.y;
        vector.z = x * axisX.z + y * axisY.z + z * axisZ.z;
        gap.squaredLength = x * x + y * y + z * z;
        gap.closing = -(x * (axisX.x * motion.x + axisX.y * motion.y + axisX.z * motion.z)
                + y * (axisY.x * motion.x + axisY.y * motion.y + axisY.z * motion.z)
                + z * (axisZ.x * motion.x + axisZ.y * motion.y + axisZ.z * motion.z));
    }
}
