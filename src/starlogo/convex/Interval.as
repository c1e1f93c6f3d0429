package starlogo.convex
{
    /**
     * How far a shape extends along a direction, as a record.
     *
     * @private
     */
    public final class Interval
    {
        /** The least component of a point along the direction. */
        public var least:Number = 0;

        /** The greatest component. */
        public var greatest:Number = 0;
    }
}
