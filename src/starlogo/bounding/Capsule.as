package starlogo.bounding
{
    import flash.geom.Vector3D;
    import starlogo.convex.ConvexShape;
    import starlogo.engine;
    import starlogo.geometry.compareVectors;
    import starlogo.geometry.Placement;
    import starlogo.geometry.Tolerances;

    use namespace engine;

    /**
     * A ball swept along a segment: all points whose distance from the segment between <code>start</code> and <code>end</code> is at most
     * <code>radius</code> (thesis §3.3). If both ends are one point, it is a ball. If the radius is 0, it is a segment.
     */
    public final class Capsule extends BoundingStructure
    {
        /** One end of the axis. */
        public var start:Vector3D;

        /** The other end of the axis. */
        public var end:Vector3D;

        /** The radius in patches, not negative. */
        public var radius:Number;

        /**
         * Creates a capsule around the segment between two points.
         *
         * @param start copied
         * @param end copied; may equal start
         * @param radius in patches; 0 is allowed
         * @throws ArgumentError if an end is null
         * @throws RangeError if a coordinate or the radius is not finite or beyond the limits of structures, or if the radius is negative
         */
        public function Capsule(start:Vector3D, end:Vector3D, radius:Number)
        {
            super(OTHER);
            kind = CAPSULE;
            checkAxis(start, end, radius, "a capsule");
            this.start = start.clone();
            this.end = end.clone();
            this.radius = radius;
        }

        /** @inheritDoc */
        override public function toString():String
        {
            return "a Capsule of radius " + radius + " from " + start + " to " + end;
        }

        /** @inheritDoc */
        override public function get volume():Number
        {
            return Math.PI * radius * radius * (Vector3D.distance(start, end) + 4 / 3 * radius);
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
            include "../geometry/pointToSegment.inc";
            var limit:Number = radius + slack(radius + Math.sqrt(lengthSquared) / 2, start);
            return x * x + y * y + z * z <= limit * limit;
        }

        /** @inheritDoc */
        override public function clone():BoundingStructure
        {
            return new Capsule(start, end, radius);
        }

        /** @inheritDoc */
        override public function place(placement:Placement, out:BoundingStructure = null):BoundingStructure
        {
            var placed:Capsule = out as Capsule || newFor(out) as Capsule;
            placement.place(start, placed.start);
            placement.place(end, placed.end);
            placed.radius = radius * placement.size;
            return placed;
        }

        /** @private */
        override engine function isAfter(other:BoundingStructure):Boolean
        {
            var capsule:Capsule = other as Capsule;
            var order:int = compareVectors(start, capsule.start) || compareVectors(end, capsule.end);
            return order > 0 || order == 0 && radius > capsule.radius;
        }

        /** @private */
        override engine function toNumbers():Vector.<Number>
        {
            return new <Number>[start.x, start.y, start.z, end.x, end.y, end.z, radius];
        }

        /** @private */
        override engine function setFromNumbers(numbers:Vector.<Number>):void
        {
            start.setTo(numbers[0], numbers[1], numbers[2]);
            end.setTo(numbers[3], numbers[4], numbers[5]);
            radius = numbers[6];
        }

        /**
         * @inheritDoc
         *
         * @private
         */
        override engine function widen(by:Number):void
        {
            radius += by;
        }

        /** @private */
        override engine function widenForSurfaces():void
        {
            // for the reason that Box.widenForSurfaces() gives
            widen(2 * Tolerances.SURFACES * (radius + 0.5 * Vector3D.distance(start, end)));
        }

        /** @private */
        override engine function setShape(out:ConvexShape):void
        {
            out.setSegment(start, end);
            out.radius = radius;
        }

        /** @private */
        override engine function findPlacedBox(placement:Placement, out:Vector.<Number>):void
        {
            var m:Placement = placement;
            var halfSize:Number = m.size / 2;
            var x:Number = (start.x + end.x) * halfSize;
            var y:Number = (start.y + end.y) * halfSize;
            var z:Number = (start.z + end.z) * halfSize;
            var toEndX:Number = (end.x - start.x) * halfSize;
            var toEndY:Number = (end.y - start.y) * halfSize;
            var toEndZ:Number = (end.z - start.z) * halfSize;
            var outerRadius:Number = radius * m.size;
            outerRadius += Tolerances.ROUNDING * (outerRadius + (Math.abs(x) + Math.abs(y) + Math.abs(z)
                        + (Math.abs(toEndX) + Math.abs(toEndY) + Math.abs(toEndZ))));
            out[0] = m.r00 * x + m.r01 * y + m.r02 * z;
            out[1] = m.r10 * x + m.r11 * y + m.r12 * z;
            out[2] = m.r20 * x + m.r21 * y + m.r22 * z;
            out[3] = Math.abs(m.r00 * toEndX + m.r01 * toEndY + m.r02 * toEndZ) + outerRadius;
            out[4] = Math.abs(m.r10 * toEndX + m.r11 * toEndY + m.r12 * toEndZ) + outerRadius;
            out[5] = Math.abs(m.r20 * toEndX + m.r21 * toEndY + m.r22 * toEndZ) + outerRadius;
        }
    }
}
