package starlogo.queries.motion
{
    import flash.geom.Vector3D;
    import starlogo.convex.ContactPoint;

    /**
     * How a motion of a character's body ends. Slider writes it.
     *
     * @private
     */
    public final class SlideResult
    {
        /** The place of the body at the end. */
        public var place:Vector3D = new Vector3D();

        /** Whether it began deep in a row. */
        public var isDeep:Boolean = false;

        /** Whether it met a wall: a surface that was too steep for it. */
        public var metWall:Boolean = false;

        /** The most level contact that it has met: the one with the greatest z of its normal. */
        public var floor:ContactPoint = new ContactPoint();

        /** The other row of that contact; -1 if it has met nothing, or a slide only what showed no contact (Impact.isNormalFallback). */
        public var floorRow:int = -1;
    }
}
