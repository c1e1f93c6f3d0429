package starlogo.ground
{
    import starlogo.convex.TrianglePlane;
    import starlogo.geometry.Touching;

    /**
     * A triangle of the ground's surface, as a record. GroundTriangles writes the corners. The box and the plane are set by PieceTrianglePairs.
     *
     * @private
     */
    public final class GroundTriangle
    {
        /** The corners, nine numbers; counter-clockwise as seen from outside of the ground. */
        public var corners:Vector.<Number> = new Vector.<Number>(9, true);

        /** Whether it is a part of an upright wall. Then its first side leads from one end of the wall to the other. */
        public var isWall:Boolean = false;

        /** A sphere with this radius around the triangle's middle contains it. It need not be the smallest. */
        public var radius:Number = 0;

        /** The box around it; set only for a triangle that is listed. */
        internal var box:GroundBox = new GroundBox();

        /** Its plane, and how far from it other shapes still touch it, because its surface is rounded (see Touching). */
        internal var plane:TrianglePlane = new TrianglePlane();
        internal var margin:Number = 0;

        /** Sets the plane and the margin. */
        internal function setPlane():void
        {
            plane.setTriangle(corners, 0);
            margin = Touching.marginOfSurface(radius);
        }
    }
}
