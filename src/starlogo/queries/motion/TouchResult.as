package starlogo.queries.motion
{
    import flash.geom.Vector3D;
    import starlogo.convex.ContactPoint;

    /**
     * Where a straight motion of a body ends in the touch of a row, or free, as a record. TouchSweep writes it.
     *
     * @private
     */
    public final class TouchResult
    {
        /** The row that stops the body; -1 for none. */
        public var row:int = -1;

        /** When the body touches it, from 0 to 1; 1 without one. */
        public var time:Number = 1;

        /** The contact with that row. Without a row it means nothing. */
        public var contact:ContactPoint = new ContactPoint();

        /** The place of the body at that time. */
        public var place:Vector3D = new Vector3D();

        /** The place of the body where the shrunk body touches the row. Without a row it means nothing. */
        public var shrunkPlace:Vector3D = new Vector3D();

        /** Whether a plane stands for the row: the body overlaps it at the start, deeply or without a way out. */
        public var hasPlane:Boolean = false;

        /** Whether a row stops it. */
        public function get hasRow():Boolean
        {
            return row >= 0;
        }
    }
}
