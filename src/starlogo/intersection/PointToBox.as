package starlogo.intersection
{
    import flash.geom.Vector3D;
    import starlogo.bounding.Box;
    import starlogo.convex.CoreGap;

    /** The vector of a gap between a point and a box, for the finders of gaps that end at a box. */
    internal final class PointToBox
    {
        /** Sets the vector to the one from the nearest point of a box to a point, in the box's axes and as seen from its middle. */
        public static function measure(x:Number, y:Number, z:Number, box:Box, out:CoreGap):void
        {
            out.x = x > box.halfX ? x - box.halfX : (x < -box.halfX ? x + box.halfX : 0);
            out.y = y > box.halfY ? y - box.halfY : (y < -box.halfY ? y + box.halfY : 0);
            out.z = z > box.halfZ ? z - box.halfZ : (z < -box.halfZ ? z + box.halfZ : 0);
        }

        /** Turns the vector from a box's axes into the box's space. */
        public static function turn(box:Box, gap:CoreGap):void
        {
            var axisX:Vector3D = box.axisX;
            var axisY:Vector3D = box.axisY;
            var axisZ:Vector3D = box.axisZ;
            var alongX:Number = gap.x;
            var alongY:Number = gap.y;
            var alongZ:Number = gap.z;
            gap.x = alongX * axisX.x + alongY * axisY.x + alongZ * axisZ.x;
            gap.y = alongX * axisX.y + alongY * axisY.y + alongZ * axisZ.y;
            gap.z = alongX * axisX.z + alongY * axisY.z + alongZ * axisZ.z;
        }
    }
}
