package starlogo.convex
{
    /**
     * How two shapes touch or overlap, as a record.
     *
     * @private
     */
    public final class ConvexContact
    {
        /** The middle of what both shapes have in common, where the first shape is at the time of the contact. */
        public var x:Number = 0;
        public var y:Number = 0;
        public var z:Number = 0;

        /** The direction in which the first shape has to move to get out of the second: a unit vector. */
        public var normalX:Number = 0;
        public var normalY:Number = 0;
        public var normalZ:Number = 1;

        /** How far it has to move, at least 0. */
        public var depth:Number = 0;
    }
}
