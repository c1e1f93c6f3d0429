package starlogo.intersection.sweep
{
    import flash.geom.Vector3D;
    import starlogo.bounding.Box;

    /**
     * Finds when a box touches another that it moves past: separating axes over time, see BoxSweep.
     *
     * @param a moves; half-extents may be 0
     * @param b in the space of a; likewise
     * @param motion of a; takes the time, from 0 to 1, or RelativeMotion.NEVER
     * @param faceAxesOnly leaves out the axes of the edges, as boxBox does
     *
     * @private
     */
    public function findBoxImpact(a:Box, b:Box, motion:RelativeMotion, faceAxesOnly:Boolean = false):void
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
        sweep.xx = aXx * x.x + aXy * x.y + aXz * x.z;
        sweep.xy = aXx * y.x + aXy * y.y + aXz * y.z;
        sweep.xz = aXx * z.x + aXy * z.y + aXz * z.z;
        sweep.yx = aYx * x.x + aYy * x.y + aYz * x.z;
        sweep.yy = aYx * y.x + aYy * y.y + aYz * y.z;
        sweep.yz = aYx * z.x + aYy * z.y + aYz * z.z;
        sweep.zx = aZx * x.x + aZy * x.y + aZz * x.z;
        sweep.zy = aZx * y.x + aZy * y.y + aZz * y.z;
        sweep.zz = aZx * z.x + aZy * z.y + aZz * z.z;
        var motionX:Number = motion.x;
        var motionY:Number = motion.y;
        var motionZ:Number = motion.z;
        sweep.motionX = -(aXx * motionX + aXy * motionY + aXz * motionZ);
        sweep.motionY = -(aYx * motionX + aYy * motionY + aYz * motionZ);
        sweep.motionZ = -(aZx * motionX + aZy * motionY + aZz * motionZ);
        sweep.prepare();
        var centerA:Vector3D = a.center;
        var centerB:Vector3D = b.center;
        var fromX:Number = centerB.x - centerA.x - motion.startX;
        var fromY:Number = centerB.y - centerA.y - motion.startY;
        var fromZ:Number = centerB.z - centerA.z - motion.startZ;
        sweep.x = aXx * fromX + aXy * fromY + aXz * fromZ;
        sweep.y = aYx * fromX + aYy * fromY + aYz * fromZ;
        sweep.z = aZx * fromX + aZy * fromY + aZz * fromZ;
        sweep.aX = a.halfX;
        sweep.aY = a.halfY;
        sweep.aZ = a.halfZ;
        sweep.bX = b.halfX;
        sweep.bY = b.halfY;
        sweep.bZ = b.halfZ;
        motion.findRounding();
        sweep.gap = motion.rounding;
        sweep.meetFaces();
        if (sweep.time != RelativeMotion.NEVER && !faceAxesOnly)
        {
            sweep.meetEdges();
        }
        motion.time = sweep.time;
    }
}
