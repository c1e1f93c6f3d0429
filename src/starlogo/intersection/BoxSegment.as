package starlogo.intersection
{
    /**
     * A segment in the axes of a box, as seen from the box's middle. The axes are mirrored so that no component of the segment's vector is
     * negative.
     */
    internal final class BoxSegment
    {
        /** The segment's start. */
        public var x:Number = 0;
        public var y:Number = 0;
        public var z:Number = 0;

        /** The vector from the segment's start to its end. Not negative. */
        public var alongX:Number = 0;
        public var alongY:Number = 0;
        public var alongZ:Number = 0;

        /** The box's half-extents. */
        public var halfX:Number = 0;
        public var halfY:Number = 0;
        public var halfZ:Number = 0;

        /** -1 for each axis that is mirrored, otherwise 1. */
        public var signX:Number = 1;
        public var signY:Number = 1;
        public var signZ:Number = 1;
    }
}
