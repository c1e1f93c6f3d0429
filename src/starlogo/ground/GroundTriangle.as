package starlogo.ground
{
    import starlogo.convex.TrianglePlane;
    import starlogo.geometry.Touching;

    /**
     * A triangle of the ground's surface, as a record.
     *
     * @private
     */
    public final class GroundTriangle
    {
        /** The corners, nine numbers; counter-clockwise as seen from outside of the ground. */
        public var corners:Vector.<Number> = new Vector.<Number>(9, true);

        /** A ball with this radius around the triangle's middle contains it. */
        public var size:Number = 0;

        /** The least and the greatest height of a corner. */
        public var low:Number = 0;
        public var high:Number = 0;

        /** The middle of the cell that it belongs to. */
        public var cellX:Number = 0;
        public var cellY:Number = 0;

        /** Its plane, if whoever found it has set that. */
        public var plane:TrianglePlane = new TrianglePlane();

        /** The margin that the triangle has because of its size. */
        public function get margin():Number
        {
            return Touching.marginOfSurface(size);
        }
    }
}
