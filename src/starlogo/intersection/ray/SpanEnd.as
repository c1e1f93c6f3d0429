package starlogo.intersection.ray
{
    import flash.geom.Vector3D;

    /**
     * An end of the part of a ray's line that is inside of a convex shape, as a record. Both distances are along the line, as the ray counts them.
     *
     * @private
     */
    public final class SpanEnd
    {
        /** Where the line touches the shape. Touching counts, so this may be a rounding error beside the shape. */
        public var touchDistance:Number = 0;

        /** Where the line crosses the surface of the shape itself. If it only touches the shape, this may be the same as the touch distance. */
        public var surfaceDistance:Number = 0;

        /** The direction of the surface's normal there, inwards or outwards. It has any length, and 0 if the shape has no surface. */
        public var normal:Vector3D = new Vector3D();

        /** Copies another end. */
        public function copyFrom(other:SpanEnd):void
        {
            touchDistance = other.touchDistance;
            surfaceDistance = other.surfaceDistance;
            normal.copyFrom(other.normal);
        }
    }
}
