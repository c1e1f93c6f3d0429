package starlogo.intersection
{
    /** Two segments: that of u, and that of v. */
    internal final class SegmentPair
    {
        /** The vector from the start of v to the start of u. */
        public var x:Number = 0;
        public var y:Number = 0;
        public var z:Number = 0;

        /** The vector from the start of u to its end. */
        public var ux:Number = 0;
        public var uy:Number = 0;
        public var uz:Number = 0;

        /** The vector from the start of v to its end. */
        public var vx:Number = 0;
        public var vy:Number = 0;
        public var vz:Number = 0;
    }
}
