package starlogo.intersection.distance
{
    /**
     * The gap between the closest points of two cores. A core is a sphere's centre, a capsule's axis or a whole box. Two structures touch
     * when the gap between their cores is as long as the sum of their radii.
     *
     * @private
     */
    public final class RoundGap
    {
        /** The vector from the second core's closest point to the first core's. */
        public var x:Number = 0;
        public var y:Number = 0;
        public var z:Number = 0;

        /** The place of the closest point on the first core, if that is a segment: from 0 at its start to 1 at its end. */
        public var share:Number = 0;

        /** How far the surface of the first structure is from its core. */
        public var radiusA:Number = 0;

        /** How far the surface of the second structure is from its core. */
        public var radiusB:Number = 0;

        /** The size of both structures together. The rounding error of the gap is relative to it. */
        public var size:Number = 0;
    }
}
