package starlogo.intersection
{
    import flash.geom.Vector3D;
    import starlogo.bounding.Box;
    import starlogo.convex.CoreGap;
    import starlogo.convex.RelativeMotion;

    /**
     * Replaces a place by the vector to it from the nearest point of a box, in the box's space.
     *
     * @param box the box
     * @param motion of the place
     * @param gap its vector is the place as seen from the box's middle, in the box's axes. Receives the vector, its squared length, and how it closes
     *
     * @private
     */
    internal function measureToBox(box:Box, motion:RelativeMotion, gap:CoreGap):void
    {
        var axisX:Vector3D = box.axisX;
        var axisY:Vector3D = box.axisY;
        var axisZ:Vector3D = box.axisZ;
        var x:Number = gap.x;
        var y:Number = gap.y;
        var z:Number = gap.z;
        x = x > box.halfX ? x - box.halfX : (x < -box.halfX ? x + box.halfX : 0);
        y = y > box.halfY ? y - box.halfY : (y < -box.halfY ? y + box.halfY : 0);
        z = z > box.halfZ ? z - box.halfZ : (z < -box.halfZ ? z + box.halfZ : 0);
        gap.x = x * axisX.x + y * axisY.x + z * axisZ.x;
        gap.y = x * axisX.y + y * axisY.y + z * axisZ.y;
        gap.z = x * axisX.z + y * axisY.z + z * axisZ.z;
        gap.squaredLength = x * x + y * y + z * z;
        gap.closing = -(x * (axisX.x * motion.x + axisX.y * motion.y + axisX.z * motion.z)
                + y * (axisY.x * motion.x + axisY.y * motion.y + axisY.z * motion.z)
                + z * (axisZ.x * motion.x + axisZ.y * motion.y + axisZ.z * motion.z));
    }
}
