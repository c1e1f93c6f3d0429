package starlogo.bounding
{
    import flash.geom.Vector3D;
    import starlogo.engine;
    import starlogo.geometry.Placement;

    use namespace engine;

    /**
     * A solid cylinder with flat ends: all points whose distance from the segment between <code>start</code> and <code>end</code>, measured
     * perpendicular to it, is at most <code>radius</code> (thesis §3.4.3). With a radius of 0 it is a segment. If both ends are one point,
     * it is that point for any radius, because a disc without an axis has no direction.
     *
     * <p>Cylinders are fitted and measured but never collided: <code>intersects</code> refuses them, because the test of two cylinders
     * needs a numerical solver (thesis §3.6.1). Use capsules instead.</p>
     */
    public final class Cylinder extends BoundingStructure
    {
        /** One end of the axis. */
        public var start:Vector3D;

        /** The other end of the axis. */
        public var end:Vector3D;

        /** The radius in patches, not negative. */
        public var radius:Number;

        /**
         * Creates a cylinder around the segment between two points.
         *
         * @param start copied
         * @param end copied; may equal start
         * @param radius in patches; 0 is allowed
         * @throws ArgumentError if an end is null
         * @throws RangeError if a coordinate or the radius is not finite or beyond the limits of structures, or if the radius is negative
         */
        public function Cylinder(start:Vector3D, end:Vector3D, radius:Number)
        {
            super(OTHER);
            checkAxis(start, end, radius, "a cylinder");
            this.start = start.clone();
            this.end = end.clone();
            this.radius = radius;
        }

        /** @inheritDoc */
        override public function toString():String
        {
            return "a Cylinder of radius " + radius + " from " + start + " to " + end;
        }

        /** @inheritDoc */
        override public function get volume():Number
        {
            return Math.PI * radius * radius * Vector3D.distance(start, end);
        }

        /** @inheritDoc */
        override public function contains(point:Vector3D):Boolean
        {
            var axisX:Number = end.x - start.x;
            var axisY:Number = end.y - start.y;
            var axisZ:Number = end.z - start.z;
            var x:Number = point.x - start.x;
            var y:Number = point.y - start.y;
            var z:Number = point.z - start.z;
            var length:Number = Math.sqrt(axisX * axisX + axisY * axisY + axisZ * axisZ);
            var tolerance:Number = slack(radius + length / 2, start);
            if (length == 0)
            {
                return x * x + y * y + z * z <= tolerance * tolerance;
            }
            var along:Number = (axisX * x + axisY * y + axisZ * z) / length;
            if (along < -tolerance || along > length + tolerance)
            {
                return false;
            }
            x -= along / length * axisX;
            y -= along / length * axisY;
            z -= along / length * axisZ;
            var limit:Number = radius + tolerance;
            return x * x + y * y + z * z <= limit * limit;
        }

        /** @inheritDoc */
        override public function clone():BoundingStructure
        {
            return new Cylinder(start, end, radius);
        }

        /** @inheritDoc */
        override public function place(placement:Placement, out:BoundingStructure = null):BoundingStructure
        {
            var placed:Cylinder = out as Cylinder || newFor(out) as Cylinder;
            placement.place(start, placed.start);
            placement.place(end, placed.end);
            placed.radius = radius * placement.size;
            return placed;
        }

        /** @inheritDoc */
        override public function extentsInto(out:Vector.<Number>, offset:int = 0):void
        {
            var axisX:Number = end.x - start.x;
            var axisY:Number = end.y - start.y;
            var axisZ:Number = end.z - start.z;
            var lengthSquared:Number = axisX * axisX + axisY * axisY + axisZ * axisZ;
            var rim:Number = lengthSquared == 0 ? 0 : radius / Math.sqrt(lengthSquared);
            var margin:Number = rounding(radius, start) + rounding(radius, end);
            writeExtent(start.x, end.x, rim * Math.sqrt(axisY * axisY + axisZ * axisZ) + margin, out, offset);
            writeExtent(start.y, end.y, rim * Math.sqrt(axisX * axisX + axisZ * axisZ) + margin, out, offset + 2);
            writeExtent(start.z, end.z, rim * Math.sqrt(axisX * axisX + axisY * axisY) + margin, out, offset + 4);
        }
    }
}
