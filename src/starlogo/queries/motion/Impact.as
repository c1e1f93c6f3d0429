package starlogo.queries.motion
{
    import starlogo.convex.ContactPoint;

    /**
     * What the shrunk body meets on a motion, as a record. ShrunkSweep writes it. A slide turns its normal (Slider).
     *
     * @private
     */
    public final class Impact
    {
        /** The row that is met. */
        public var row:int = -1;

        /** When the shrunk body meets it, as a fraction of the motion. */
        public var time:Number = Infinity;

        /** The contact of the shrunk body at <code>time</code>. Its normal points against the motion. */
        public var contact:ContactPoint = new ContactPoint();

        /** Whether no contact points against the motion. Then the normal is the opposite of the motion. */
        public var isNormalFallback:Boolean = false;
    }
}
