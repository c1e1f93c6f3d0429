package starlogo.ground
{
    /**
     * A place of the ground, as a record: where it is, how high the ground is there, and of which triangle that height is.
     *
     * @private
     */
    public final class GroundPoint
    {
        /** The place, in the world. */
        public var x:Number = NaN;
        public var y:Number = NaN;

        /** The height there; NaN outside of the ground and over a hole; Infinity if <code>findNearest()</code> found no ground. */
        public var height:Number = NaN;

        /**
         * The triangle of a slope: indices of the height of its cell with the least x and y, and of the height beside the diagonal. The third
         * is opposite to the first.
         */
        public var corner:int = 0;
        public var side:int = 0;
    }
}
