package starlogo.ground
{
    import flash.geom.Vector3D;
    import starlogo.convex.TrianglePlane;

    /**
     * A triangle of the ground's surface, as a record.
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

        /**
         * The least and the greatest corner of a box around it: around its cell as seen from above, and between the least and the greatest height of a
         * corner. The box is larger by the slack of GroundTriangles.
         */
        public var min:Vector3D = new Vector3D();
        public var max:Vector3D = new Vector3D();

        /** The margin of its surface (see Touching) and its plane. Only KeptTriangles sets them. */
        public var margin:Number = 0;
        public var plane:TrianglePlane = new TrianglePlane();
    }
}
