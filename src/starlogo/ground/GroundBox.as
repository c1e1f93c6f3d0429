package starlogo.ground
{
    import starlogo.convex.ConvexShape;
    import starlogo.convex.RelativeMotion;
    import starlogo.geometry.Placement;

    /**
     * The box near which GroundTriangles finds triangles, as a record, and what else limits the search. All is set before the search. During the
     * search, only the limits may be narrowed.
     *
     * @private
     */
    public final class GroundBox
    {
        /** The place in the world to which the box and the triangles are relative. It has no rotation and no scale. */
        public var origin:Placement = new Placement();

        /** The middle of the box at time 0. */
        public var x:Number = 0;
        public var y:Number = 0;
        public var z:Number = 0;

        /** Half the box's lengths. */
        public var halfX:Number = 0;
        public var halfY:Number = 0;
        public var halfZ:Number = 0;

        /** The box's motion; RelativeMotion.NONE if it stands. Only x, y and z count. */
        public var motion:RelativeMotion = RelativeMotion.NONE;

        /** The shape that is tested, if it is in the box; null for none. Squares that it clearly does not come near are left out. */
        public var shape:ConvexShape = null;

        /** The height, relative to the origin, down to which walls reach at the ground's borders and around holes. -Infinity: to below the box. */
        public var floor:Number = -Infinity;

        /** A limit: the latest time that counts, as a multiple of the motion. The corners of the triangles that are still found do not depend on it. */
        public var latest:Number = 1;

        /** A limit: how far from the standing box a triangle still counts. */
        public var maxDistance:Number = 0;

        /** A limit: only triangles count that are clearly higher than this above the bottom of the box. */
        public var above:Number = -Infinity;
    }
}
