package starlogo.convex
{
    import flash.geom.Vector3D;

    /**
     * The gap between the closest points of two cores, as a record. A core is a sphere's centre, a capsule's axis, or a whole box, triangle or hull.
     * Two shapes touch if the gap between their cores is at most as long as their radii together, except for the margins of Touching. All numbers
     * are in the space of the two shapes. a is the first of a CorePair, or of the two that a kernel takes in order; b is the second.
     *
     * @private
     */
    public final class CoreGap
    {
        /** The vector from the closest point of b's core to that of a's core. */
        public var x:Number = 0;
        public var y:Number = 0;
        public var z:Number = 0;

        /** The closest point of a's core, where a is stored, without its motion. */
        public var point:Vector3D = new Vector3D();

        /** The radius around a's core. */
        public var radiusA:Number = 0;

        /** The radius around b's core. */
        public var radiusB:Number = 0;
    }
}
