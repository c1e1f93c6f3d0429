package starlogo.bounding
{
    import flash.geom.Vector3D;
    import starlogo.engine;
    import starlogo.geometry.Placement;

    use namespace engine;

    /** Base class of Capsule and Cylinder: an axis between two points, and a radius. Abstract. */
    public class AxialStructure extends BoundingStructure
    {
        /** One end of the axis. */
        public var start:Vector3D;

        /** The other end of the axis. */
        public var end:Vector3D;

        /** The radius in patches, not negative. */
        public var radius:Number;

        /**
         * For subclasses only.
         *
         * @param kind one of BoundingStructure's constants
         * @param start copied
         * @param end copied; may equal start
         * @param radius in patches; 0 is allowed
         * @param name the structure's name in messages
         * @throws ArgumentError if an end is null
         * @throws RangeError if the radius is negative, or if a number is not finite or beyond the limits of structures
         */
        public function AxialStructure(kind:int, start:Vector3D, end:Vector3D, radius:Number, name:String)
        {
            super(kind);
            this.radius = checkLength(radius, "the radius of a " + name);
            this.start = checkVector(start, "the start of a " + name).clone();
            this.end = checkVector(end, "the end of a " + name).clone();
            checkSize(Math.max(Math.max(radius, Math.abs(end.x - start.x)), Math.max(Math.abs(end.y - start.y), Math.abs(end.z - start.z))), "a " + name);
        }

        /** @inheritDoc */
        override public function place(placement:Placement, out:BoundingStructure = null):BoundingStructure
        {
            var placed:AxialStructure = out as AxialStructure;
            if (placed == null || placed.kind != kind)
            {
                placed = newFor(out) as AxialStructure;
            }
            placement.place(start, placed.start);
            placement.place(end, placed.end);
            placed.radius = radius * placement.size;
            return placed;
        }

        /** @private */
        override engine function numbers():Vector.<Number>
        {
            return new <Number>[start.x, start.y, start.z, end.x, end.y, end.z, radius];
        }

        /** @private */
        override engine function setNumbers(numbers:Vector.<Number>):void
        {
            start.setTo(numbers[0], numbers[1], numbers[2]);
            end.setTo(numbers[3], numbers[4], numbers[5]);
            radius = numbers[6];
        }
    }
}
