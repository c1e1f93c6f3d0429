package starlogo.ground
{
    /**
     * A triangle of the ground's surface, as a record.
     *
     * @private
     */
    public final class GroundTriangle
    {
        /** The corners, nine numbers; counter-clockwise as seen from outside of the ground. */
        public var corners:Vector.<Number> = new Vector.<Number>(9, true);

        /** A length that no side is longer than. */
        public var size:Number = 0;

        /** The margin that the triangle has because of its size (see Touching). */
        public var margin:Number = 0;

        /** Becomes the same as another triangle. */
        public function copyFrom(other:GroundTriangle):void
        {
            for (var i:int = 0; i < 9; i++)
            {
                corners[i] = other.corners[i];
            }
            size = other.size;
            margin = other.margin;
        }
    }
}
