package starlogo.ground
{
    import starlogo.convex.ConvexShape;
    import starlogo.convex.RelativeMotion;
    import starlogo.geometry.Placement;

    /**
     * Which triangles of the ground GroundTriangles finds, as a record: those near a box, which stands or moves. All is set before the search
     * begins. During the search, only the limits may be narrowed.
     */
    internal final class GroundSearch
    {
        /** The ground. */
        public var grid:HeightGrid = null;

        /** The place in the world to which the box and the triangles are relative. Only its x, y and z count. */
        public var origin:Placement = new Placement();

        /** The box at time 0. */
        public var box:GroundBox = new GroundBox();

        /**
         * The box's motion: the vector is 0 if the box stands. For a ray the vector is its direction, and times are distances, which may be more than 1.
         * Of its times, the latest counts. It is a limit: it may become earlier during the search. The corners of the triangles that are still found do
         * not depend on it.
         */
        public var motion:RelativeMotion = new RelativeMotion();

        /** The shape that is tested, if it is in the box; null for none. Squares that it clearly does not come near are left out. */
        public var shape:ConvexShape = null;

        /** The lower end, relative to the origin, of walls at the ground's borders and around holes. -Infinity: below the box. */
        public var floor:Number = -Infinity;

        /** A limit: how far from the standing box a triangle still counts. Tall walls are cut beyond it. */
        public var maxDistance:Number = 0;
    }
}
