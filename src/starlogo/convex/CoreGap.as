package starlogo.convex
{
    import flash.geom.Vector3D;
    import starlogo.bounding.Box;

    /**
     * The gap between the closest points of two cores, as a record. A core is a sphere's centre, a capsule's axis, or a whole box, triangle or hull.
     * Two shapes touch when the gap between their cores is at most as long as the sum of their radii.
     *
     * @private
     */
    public final class CoreGap
    {
        /** The vector from the second core's closest point to the first core's. */
        public var x:Number = 0;
        public var y:Number = 0;
        public var z:Number = 0;

        /** The first core's closest point. */
        public var pointX:Number = 0;
        public var pointY:Number = 0;
        public var pointZ:Number = 0;

        /** The radius around the first core. */
        public var radiusA:Number = 0;

        /** The radius around the second core. */
        public var radiusB:Number = 0;

        /** The extent of both shapes together. The rounding error of the gap is relative to it. Only a GapFinder sets it; otherwise it is 0. */
        public var extent:Number = 0;

        /** Sets the vector to the one from the nearest point of a box to a point, in the box's axes and as seen from its middle. */
        public function setFromBox(x:Number, y:Number, z:Number, box:Box):void
        {
            this.x = x > box.halfX ? x - box.halfX : (x < -box.halfX ? x + box.halfX : 0);
            this.y = y > box.halfY ? y - box.halfY : (y < -box.halfY ? y + box.halfY : 0);
            this.z = z > box.halfZ ? z - box.halfZ : (z < -box.halfZ ? z + box.halfZ : 0);
        }

        /** Turns the vector out of three perpendicular axes. */
        public function rotateFrom(axisX:Vector3D, axisY:Vector3D, axisZ:Vector3D):void
        {
            var alongX:Number = x;
            var alongY:Number = y;
            var alongZ:Number = z;
            x = alongX * axisX.x + alongY * axisY.x + alongZ * axisZ.x;
            y = alongX * axisX.y + alongY * axisY.y + alongZ * axisZ.y;
            z = alongX * axisX.z + alongY * axisY.z + alongZ * axisZ.z;
        }
    }
}
