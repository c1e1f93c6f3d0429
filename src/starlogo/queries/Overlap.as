package starlogo.queries
{
    import starlogo.convex.ContactPoint;

    /**
     * The deepest overlap of a body with some rows. OverlapRecovery writes it.
     *
     * @private
     */
    public final class Overlap
    {
        /** The contact of the deepest overlap. A push along its normal by its depth leads a clearance out of the row. */
        public var contact:ContactPoint = new ContactPoint();

        /** The sum of the depths of all overlaps. */
        public var sum:Number = 0;
    }
}
