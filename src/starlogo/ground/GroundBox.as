package starlogo.ground
{
    /**
     * An axis-aligned box, as a record.
     *
     * @private
     */
    public final class GroundBox
    {
        /** The middle. */
        public var x:Number = 0;
        public var y:Number = 0;
        public var z:Number = 0;

        /** Half the lengths. */
        public var halfX:Number = 0;
        public var halfY:Number = 0;
        public var halfZ:Number = 0;
    }
}
