package starlogo.intersection
{
    import flash.geom.Vector3D;
    import starlogo.bounding.Box;
    import starlogo.convex.CoreGap;
    import starlogo.convex.RelativeMotion;

    /**
     * The gap between the cores of two structures of which the first moves, with what RoundKernel has to know about it, as a record. A GapFinder
     * writes it.
     *
     * @private
     */
    public final class RoundGap
    {
        /** The gap and the radii. The closest point is where the first structure is stored, without its motion. */
        public var cores:CoreGap = new CoreGap();

        /** The squared length of the gap. At a box it is more precise than its vector. */
        public var squaredLength:Number = 0;

        /** How fast the motion closes the gap, times the length of the gap. */
        public var closing:Number = 0;

        /** The extent of both structures together, which the rounding error of the gap is relative to. */
        public var extent:Number = 0;

        /**
         * Computes the gap between a place and the nearest point of a box, its squared length, and how a motion of the place closes it. The vector has to
         * be the place as seen from the box's middle, in the box's axes. It becomes the gap, in the box's space.
         */
        public function measureToBox(box:Box, motion:RelativeMotion):void
        {
            var axisX:Vector3D = box.axisX;
            var axisY:Vector3D = box.axisY;
            var axisZ:Vector3D = box.axisZ;
            var vector:CoreGap = cores;
            var x:Number = vector.x;
            var y:Number = vector.y;
            var z:Number = vector.z;
            x = x > box.halfX ? x - box.halfX : (x < -box.halfX ? x + box.halfX : 0);
            y = y > box.halfY ? y - box.halfY : (y < -box.halfY ? y + box.halfY : 0);
            z = z > box.halfZ ? z - box.halfZ : (z < -box.halfZ ? z + box.halfZ : 0);
            vector.x = x * axisX.x + y * axisY.x + z * axisZ.x;
            vector.y = x * axisX.y + y * axisY.y + z * axisZ.y;
            vector.z = x * axisX.z + y * axisY.z + z * axisZ.z;
            squaredLength = x * x + y * y + z * z;
            closing = -(x * (axisX.x * motion.x + axisX.y * motion.y + axisX.z * motion.z)
                    + y * (axisY.x * motion.x + axisY.y * motion.y + axisY.z * motion.z)
                    + z * (axisZ.x * motion.x + axisZ.y * motion.y + axisZ.z * motion.z));
        }
    }
}
