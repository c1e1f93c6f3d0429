package starlogo.intersection.ray
{
    /**
     * Where a ray meets a triangle, as a record. ShearedRay finds it.
     *
     * @private
     */
    public final class TriangleCrossing
    {
        /** The distance of the place, as the ray counts distances; Infinity if there is none. */
        public var distance:Number = 0;

        /** How far the distance may be wrong because of rounding. */
        public var rounding:Number = 0;

        /** Where the ray leaves a triangle that it sees edge on, or where it meets any other one. */
        public var end:Number = 0;

        /** RayCrossings.FRONT, BACK or EDGE_ON. */
        public var side:int = 0;
    }
}
