package starlogo.ground
{
    /**
     * A triangle of the ground's surface, as a record.
     *
     * @private
     */
    public class GroundTriangle
    {
        /** The corners, nine numbers; counter-clockwise as seen from outside of the ground. */
        public var corners:Vector.<Number> = new Vector.<Number>(9, true);

        /** Whether it is a part of an upright wall. Then its first side leads from one end of the wall to the other. */
        public var isWall:Boolean = false;

        /** A sphere with this radius around the triangle's middle contains it. It need not be the smallest. */
        public var radius:Number = 0;
    }
}
