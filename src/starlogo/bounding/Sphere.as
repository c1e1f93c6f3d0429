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
     * A ball: all points whose distance from <code>center</code> is at most <code>radius</code> (thesis §3.3). A radius of 0 makes it a
     * point.
     */
    public final class Sphere extends BoundingStructure
    {
        /** The middle. */
        public var center:Vector3D;

        /** The radius in patches, not negative. */
        public var radius:Number;

        /**
         * Creates a ball around a point.
         *
         * @param center copied
         * @param radius in patches; 0 is allowed
         * @throws ArgumentError if the centre is null
         * @throws RangeError if the radius is negative, or if a number is not finite or beyond the limits of structures
         */
        public function Sphere(center:Vector3D, radius:Number)
        {
            super(OTHER);
            kind = SPHERE;
            this.radius = checkLength(radius, "the radius of a sphere");
            this.center = checkVector(center, "the centre of a sphere").clone();
            checkSize(radius, "a sphere");
        }

        /** @inheritDoc */
        override public function toString():String
        {
            return "a Sphere of radius " + radius + " at " + center;
        }

        /** @inheritDoc */
        override public function get volume():Number
        {
            return 4 / 3 * Math.PI * radius * radius * radius;
        }

        /** @inheritDoc */
        override public function contains(point:Vector3D):Boolean
        {
            var x:Number = point.x - center.x;
            var y:Number = point.y - center.y;
            var z:Number = point.z - center.z;
            var limit:Number = radius + slack(radius, center);
            return x * x + y * y + z * z <= limit * limit;
        }

        /** @inheritDoc */
        override public function clone():BoundingStructure
        {
            return new Sphere(center, radius);
        }

        /** @inheritDoc */
        override public function place(placement:Placement, out:BoundingStructure = null):BoundingStructure
        {
            var placed:Sphere = out as Sphere || newFor(out) as Sphere;
            placement.place(center, placed.center);
            placed.radius = radius * placement.size;
            return placed;
        }

        /** @inheritDoc */
        override public function extentsInto(out:Vector.<Number>, offset:int = 0):void
        {
            // This repeats rounding(), because V8 would allocate objects for Numbers that are passed.
            var outerRadius:Number = radius + Tolerances.ROUNDING * (radius + Math.abs(center.x) + Math.abs(center.y) + Math.abs(center.z));
            writeExtent(center.x, center.x, outerRadius, out, offset);
            writeExtent(center.y, center.y, outerRadius, out, offset + 2);
            writeExtent(center.z, center.z, outerRadius, out, offset + 4);
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
        override engine function setShape(out:ConvexShape):void
        {
            out.setPoint(center);
            out.radius = radius;
        }

        /** @private */
        override engine function isAfter(other:BoundingStructure):Boolean
        {
            var sphere:Sphere = other as Sphere;
            var order:int = compareVectors(center, sphere.center);
            return order > 0 || order == 0 && radius > sphere.radius;
        }

        /** @private */
        override engine function toNumbers():Vector.<Number>
        {
            return new <Number>[center.x, center.y, center.z, radius];
        }

        /** @private */
        override engine function setFromNumbers(numbers:Vector.<Number>):void
        {
            center.setTo(numbers[0], numbers[1], numbers[2]);
            radius = numbers[3];
        }

        /** @private */
        override engine function findPlacedBox(placement:Placement, out:Vector.<Number>):void
        {
            var size:Number = placement.size;
            var x:Number = center.x * size;
            var y:Number = center.y * size;
            var z:Number = center.z * size;
            var half:Number = radius * size;
            out[0] = placement.r00 * x + placement.r01 * y + placement.r02 * z;
            out[1] = placement.r10 * x + placement.r11 * y + placement.r12 * z;
            out[2] = placement.r20 * x + placement.r21 * y + placement.r22 * z;
            out[3] = half;
            out[4] = half;
            out[5] = half;
        }
    }
}
