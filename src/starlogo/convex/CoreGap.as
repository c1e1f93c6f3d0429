package starlogo.convex
{
    /**
     * The gap between the closest points of two cores, as a record. A core is a sphere's centre, a capsule's axis, or a whole box, triangle or hull.
     * Two shapes touch if the gap between their cores is at most as long as their radii together, except for the margins of Touching.
     *
     * @private
     */
    public final class CoreGap
    {
        /** The vector from the second core's closest point to the first core's. */
        public var x:Number = 0;
        public var y:Number = 0;
        public var z:Number = 0;

        /** The first core's closest point. */
        public var pointX:Number = 0;
        public var pointY:Number = 0;
        public var pointZ:Number = 0;

        /** The radius around the first core. */
        public var radiusA:Number = 0;

        /** The radius around the second core. */
        public var radiusB:Number = 0;

        /** The extent of both shapes together. The rounding error of the gap is relative to it. Only a GapFinder sets it; otherwise it is 0. */
        public var extent:Number = 0;
    }
}
