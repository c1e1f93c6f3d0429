package starlogo.ground
{
    /**
     * An axis-aligned box, as a record: what a GroundSearch looks near, or the extents of an agent.
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

        /** Becomes the same as another box. */
        public function copyFrom(other:GroundBox):void
        {
            x = other.x;
            y = other.y;
            z = other.z;
            halfX = other.halfX;
            halfY = other.halfY;
            halfZ = other.halfZ;
        }
    }
}
