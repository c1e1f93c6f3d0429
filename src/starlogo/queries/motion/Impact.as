package starlogo.queries.motion
{
    import starlogo.convex.ContactPoint;

    /**
     * What stops the shrunk body on a motion, as a record: a row that it meets, or a plane of an overlap, which stops it at once. ShrunkSweep writes
     * it. A slide turns its normal (Slider).
     *
     * @private
     */
    public final class Impact
    {
        /** The row that is met; -1 if none is. */
        public var row:int = -1;

        /** When the shrunk body meets it, as a fraction of the motion. Without a row, this and all below mean nothing. */
        public var time:Number = Infinity;

        /** The contact of the shrunk body at <code>time</code>. Its normal points against the motion. */
        public var contact:ContactPoint = new ContactPoint();

        /** Whether no contact points against the motion. Then the normal is the opposite of the motion. */
        public var isNormalFallback:Boolean = false;

        /** Whether a row is met. */
        public function get hasRow():Boolean
        {
            return row >= 0;
        }

        /** Becomes a copy of another impact. */
        public function copyFrom(other:Impact):void
        {
            row = other.row;
            time = other.time;
            contact.copyFrom(other.contact);
            isNormalFallback = other.isNormalFallback;
        }
    }
}
