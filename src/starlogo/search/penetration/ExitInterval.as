package starlogo.search.penetration
{
    /** Two distances along a direction, as a record. The place at which two bodies part is between them. */
    internal final class ExitInterval
    {
        /** A distance at which the two touch. */
        public var inner:Number = 0;

        /** A distance at which they do not touch, or which is still to be tested. */
        public var outer:Number = 0;

        /** How much farther out is tested next if they touch at the outer distance. */
        public var step:Number = 0;
    }
}
