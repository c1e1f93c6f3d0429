package starlogo.ground
{
    /**
     * A place of the ground, as a record: where it is, in which cell, and how high the ground is there.
     *
     * @private
     */
    public final class GroundPoint
    {
        /** The place, in the world. */
        public var x:Number = NaN;
        public var y:Number = NaN;

        /** The column and the row of its cell. */
        public var column:int = 0;
        public var row:int = 0;

        /** On slopes: whether it is in the triangle at the cell's side with the greatest x, and not in the one at the side with the greatest y. */
        public var isBesideX:Boolean = false;

        /** The height there; NaN outside of the ground and over a hole. */
        public var height:Number = NaN;
    }
}
