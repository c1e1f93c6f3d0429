package starlogo.intersection.sweep
{
    import flash.geom.Vector3D;
    import starlogo.bounding.Box;

    /**
     * When a box touches another that it moves past: separating axes over time, see BoxSweep.
     *
     * @param a moves; half-extents may be 0
     * @param b in the space of a; likewise
     * @param motion of a
     * @param faceAxesOnly leaves out the axes of the edges, as boxBox does
     * @return from 0 to 1, or RelativeMotion.NEVER
     *
     * @private
     */
    public function boxBoxImpact(a:Box, b:Box, motion:RelativeMotion, faceAxesOnly:Boolean = false):Number
    {
        var axisX:Vector3D = a.axisX;
        var aXx:Number = axisX.x;
        var aXy:Number = axisX.y;
        var aXz:Number = axisX.z;
        var axisY:Vector3D = a.axisY;
        var aYx:Number = axisY.x;
        var aYy:Number = axisY.y;
        var aYz:Number = axisY.z;
        var axisZ:Vector3D = a.axisZ;
        var aZx:Number = axisZ.x;
        var aZy:Number = axisZ.y;
        var aZz:Number = axisZ.z;
        var x:Vector3D = b.axisX;
        var y:Vector3D = b.axisY;
        var z:Vector3D = b.axisZ;
        var sweep:BoxSweep = BoxSweep.SCRATCH;
        sweep.turn(aXx * x.x + aXy * x.y + aXz * x.z, aXx * y.x + aXy * y.y + aXz * y.z, aXx * z.x + aXy * z.y + aXz * z.z,
                aYx * x.x + aYy * x.y + aYz * x.z, aYx * y.x + aYy * y.y + aYz * y.z, aYx * z.x + aYy * z.y + aYz * z.z,
                aZx * x.x + aZy * x.y + aZz * x.z, aZx * y.x + aZy * y.y + aZz * y.z, aZx * z.x + aZy * z.y + aZz * z.z);
        var motionX:Number = motion.x;
        var motionY:Number = motion.y;
        var motionZ:Number = motion.z;
        sweep.move(-(aXx * motionX + aXy * motionY + aXz * motionZ), -(aYx * motionX + aYy * motionY + aYz * motionZ),
                -(aZx * motionX + aZy * motionY + aZz * motionZ));
        var centerA:Vector3D = a.center;
        var centerB:Vector3D = b.center;
        var fromX:Number = centerB.x - centerA.x - motion.startX;
        var fromY:Number = centerB.y - centerA.y - motion.startY;
        var fromZ:Number = centerB.z - centerA.z - motion.startZ;
        var tX:Number = aXx * fromX + aXy * fromY + aXz * fromZ;
        var tY:Number = aYx * fromX + aYy * fromY + aYz * fromZ;
        var tZ:Number = aZx * fromX + aZy * fromY + aZz * fromZ;
        var gap:Number = motion.rounding();
        var time:Number = sweep.facesMeet(tX, tY, tZ, a.halfX, a.halfY, a.halfZ, b.halfX, b.halfY, b.halfZ, gap, 1);
        if (time == RelativeMotion.NEVER || faceAxesOnly)
        {
            return time;
        }
        return sweep.edgesMeet(tX, tY, tZ, a.halfX, a.halfY, a.halfZ, b.halfX, b.halfY, b.halfZ, gap);
    }
}
