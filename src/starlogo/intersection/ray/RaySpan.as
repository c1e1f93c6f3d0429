package starlogo.intersection.ray
{
    /**
     * The part of a ray's line that is inside of a convex shape, as a record. SpanFinder finds it. The part may be before the ray begins or after it
     * ends.
     *
     * @private
     */
    public final class RaySpan
    {
        /** Where the line enters the shape. */
        public var near:SpanEnd = new SpanEnd();

        /** Where the line leaves the shape. */
        public var far:SpanEnd = new SpanEnd();

        /** Sets the places of both ends, for a shape whose touched surface is its own. */
        public function setPlaces(near:Number, far:Number):void
        {
            this.near.touchDistance = this.near.surfaceDistance = near;
            this.far.touchDistance = this.far.surfaceDistance = far;
        }
    }
}
