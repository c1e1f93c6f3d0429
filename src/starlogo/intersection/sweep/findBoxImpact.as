package starlogo.intersection.sweep
{
    import flash.geom.Vector3D;
    import starlogo.bounding.Box;
    import starlogo.convex.RelativeMotion;
    import starlogo.intersection.BoxAxes;

    /**
     * Finds when a moving box first touches another box, by separating axes over time (see BoxSweep).
     *
     * @param a moves; half-extents may be 0
     * @param b in the space of a; half-extents may be 0
     * @param motion the motion of a; receives the time, from 0 to 1, or RelativeMotion.NEVER
     * @private
     */
    public function findBoxImpact(a:Box, b:Box, motion:RelativeMotion):void
    {
        var x:Vector3D = b.axisX;
        var y:Vector3D = b.axisY;
        var z:Vector3D = b.axisZ;
        var motionX:Number = motion.x;
        var motionY:Number = motion.y;
        var motionZ:Number = motion.z;
        var fromX:Number = b.center.x - a.center.x - motion.startX;
        var fromY:Number = b.center.y - a.center.y - motion.startY;
        var fromZ:Number = b.center.z - a.center.z - motion.startZ;
        var sweep:BoxSweep = BoxSweep.SCRATCH;
        var axes:BoxAxes = sweep.axes;
        var axis:Vector3D = a.axisX;
        axes.xx = axis.x * x.x + axis.y * x.y + axis.z * x.z;
        axes.xy = axis.x * y.x + axis.y * y.y + axis.z * y.z;
        axes.xz = axis.x * z.x + axis.y * z.y + axis.z * z.z;
        sweep.motionX = -(axis.x * motionX + axis.y * motionY + axis.z * motionZ);
        sweep.x = axis.x * fromX + axis.y * fromY + axis.z * fromZ;
        axis = a.axisY;
        axes.yx = axis.x * x.x + axis.y * x.y + axis.z * x.z;
        axes.yy = axis.x * y.x + axis.y * y.y + axis.z * y.z;
        axes.yz = axis.x * z.x + axis.y * z.y + axis.z * z.z;
        sweep.motionY = -(axis.x * motionX + axis.y * motionY + axis.z * motionZ);
        sweep.y = axis.x * fromX + axis.y * fromY + axis.z * fromZ;
        axis = a.axisZ;
        axes.zx = axis.x * x.x + axis.y * x.y + axis.z * x.z;
        axes.zy = axis.x * y.x + axis.y * y.y + axis.z * y.z;
        axes.zz = axis.x * z.x + axis.y * z.y + axis.z * z.z;
        sweep.motionZ = -(axis.x * motionX + axis.y * motionY + axis.z * motionZ);
        sweep.z = axis.x * fromX + axis.y * fromY + axis.z * fromZ;
        axes.measureAxes();
        sweep.aX = a.halfX;
        sweep.aY = a.halfY;
        sweep.aZ = a.halfZ;
        sweep.bX = b.halfX;
        sweep.bY = b.halfY;
        sweep.bZ = b.halfZ;
        motion.findRounding();
        sweep.gap = motion.rounding;
        sweep.meetFaces();
        if (sweep.time != RelativeMotion.NEVER)
        {
            sweep.meetEdges();
        }
        motion.time = sweep.time;
    }
}
