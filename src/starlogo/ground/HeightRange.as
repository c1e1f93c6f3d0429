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

        /** The greatest difference of two heights that are neighbours along x. */
        public var stepX:Number = 0;

        /** The greatest along y. */
        public var stepY:Number = 0;

        /** Whether a cell there is a hole. The heights of holes count too. */
        public var hasHole:Boolean = false;
    }
}
