package starlogo.ground
{
    /**
     * Bounds of the heights in a part of the ground, and of how steep it is, as a record. HeightPyramid finds them, so that tests need not read all heights.
     *
     * @private
     */
    public final class HeightBounds
    {
        /** The least height; Infinity if there is none. */
        public var min:Number = Infinity;

        /** The greatest height; -Infinity if there is none. */
        public var max:Number = -Infinity;

        /** The most by which two heights differ that are neighbours along x. */
        public var maxStepX:Number = 0;

        /** The same along y. */
        public var maxStepY:Number = 0;

        /** Whether a cell there is a hole. The heights of holes count too. */
        public var hasHole:Boolean = false;

        /** Whether all cells there are holes. */
        public var isAllHoles:Boolean = true;
    }
}
