package starlogo.intersection.sweep
{
    import flash.geom.Vector3D;
    import starlogo.bounding.Box;
    import starlogo.convex.RelativeMotion;
    import starlogo.geometry.Tolerances;

    /**
     * A sweep of two boxes, as a record: where box b is at time 0, how it moves until time 1, and the time of impact that BoxSweep writes. All
     * numbers are in the axes of box a. Many pairs of boxes may have the same axes and motion. Then these are set once for all of them.
     *
     * @private
     */
    public final class BoxPairMotion
    {
        /** The axes of b. */
        public var axes:BoxAxes = new BoxAxes();

        /** The motion of b from time 0 to 1 as seen from a. */
        public var motionX:Number = 0;
        public var motionY:Number = 0;
        public var motionZ:Number = 0;

        /** The gap across which the boxes still touch: the sum of the margins (see Touching). */
        public var margin:Number = 0;

        /** The vector from a's middle to b's at time 0. */
        public var x:Number = 0;
        public var y:Number = 0;
        public var z:Number = 0;

        /** The half-extents of a. */
        public var aX:Number = 0;
        public var aY:Number = 0;
        public var aZ:Number = 0;

        /** The half-extents of b. */
        public var bX:Number = 0;
        public var bY:Number = 0;
        public var bZ:Number = 0;

        /** The latest time that counts: see RelativeMotion. */
        public var latest:Number = 1;

        /** The result: the time from which the axes that were tried do not separate the boxes, or RelativeMotion.NEVER. */
        public var time:Number = RelativeMotion.NEVER;

        /** Sets two boxes and the motion of a. While a moves, b moves in the opposite direction as seen from a. */
        public function setBoxes(a:Box, b:Box, motion:RelativeMotion):void
        {
            var cosines:BoxAxes = axes;
            var edgeX:Vector3D = b.axisX;
            var edgeY:Vector3D = b.axisY;
            var edgeZ:Vector3D = b.axisZ;
            var moveX:Number = motion.x;
            var moveY:Number = motion.y;
            var moveZ:Number = motion.z;
            var fromX:Number = b.center.x - a.center.x - motion.startX;
            var fromY:Number = b.center.y - a.center.y - motion.startY;
            var fromZ:Number = b.center.z - a.center.z - motion.startZ;
            var axis:Vector3D = a.axisX;
            cosines.m00 = axis.x * edgeX.x + axis.y * edgeX.y + axis.z * edgeX.z;
            cosines.m01 = axis.x * edgeY.x + axis.y * edgeY.y + axis.z * edgeY.z;
            cosines.m02 = axis.x * edgeZ.x + axis.y * edgeZ.y + axis.z * edgeZ.z;
            motionX = -(axis.x * moveX + axis.y * moveY + axis.z * moveZ);
            x = axis.x * fromX + axis.y * fromY + axis.z * fromZ;
            axis = a.axisY;
            cosines.m10 = axis.x * edgeX.x + axis.y * edgeX.y + axis.z * edgeX.z;
            cosines.m11 = axis.x * edgeY.x + axis.y * edgeY.y + axis.z * edgeY.z;
            cosines.m12 = axis.x * edgeZ.x + axis.y * edgeZ.y + axis.z * edgeZ.z;
            motionY = -(axis.x * moveX + axis.y * moveY + axis.z * moveZ);
            y = axis.x * fromX + axis.y * fromY + axis.z * fromZ;
            axis = a.axisZ;
            cosines.m20 = axis.x * edgeX.x + axis.y * edgeX.y + axis.z * edgeX.z;
            cosines.m21 = axis.x * edgeY.x + axis.y * edgeY.y + axis.z * edgeY.z;
            cosines.m22 = axis.x * edgeZ.x + axis.y * edgeZ.y + axis.z * edgeZ.z;
            motionZ = -(axis.x * moveX + axis.y * moveY + axis.z * moveZ);
            z = axis.x * fromX + axis.y * fromY + axis.z * fromZ;
            cosines.measureAxes();
            aX = a.halfX;
            aY = a.halfY;
            aZ = a.halfZ;
            bX = b.halfX;
            bY = b.halfY;
            bZ = b.halfZ;
            include "../../convex/motionMargin.inc";
            this.margin = margin;
            latest = motion.latest;
        }
    }
}
