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
        public var min:Number = 0;

        /** The greatest component. */
        public var max:Number = 0;
    }
}
