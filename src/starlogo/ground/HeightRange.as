package starlogo.ground
{
    /**
     * Bounds of the heights of some part of the ground, as a record.
     *
     * @private
     */
    public final class HeightRange
    {
        /** The least height; Infinity if there is none. */
        public var least:Number = Infinity;

        /** The greatest height; -Infinity if there is none. */
        public var greatest:Number = -Infinity;

        /** No two heights that are neighbours along x differ by more. Of squares above level 0, and of a whole grid, it is the same along y. */
        public var stepX:Number = 0;

        /** The same along y. */
        public var stepY:Number = 0;

        /** Whether a cell there is a hole. The heights of holes count too. */
        public var hasHole:Boolean = false;
    }
}
