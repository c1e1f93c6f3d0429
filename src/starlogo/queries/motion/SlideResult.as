package starlogo.queries.motion
{
    import flash.geom.Vector3D;
    import starlogo.convex.ContactPoint;

    /**
     * How a slide of a body ends, as a record. Slider.slide() writes it.
     *
     * @private
     */
    public final class SlideResult
    {
        /** The place of the body at the end. */
        public var place:Vector3D = new Vector3D();

        /** The length of its way, as a fraction of the length of the motion, from 0 to 1. */
        public var fraction:Number = 1;

        /** The row of the last wall that it met, a surface that was too steep for it; -1 if it met none. */
        public var wallRow:int = -1;

        /** The most level contact that it has met: the one with the greatest z of its normal. */
        public var floor:ContactPoint = new ContactPoint();

        /** The row of that contact; -1 if it has met nothing, or only what showed no contact (Impact.isNormalFallback). */
        public var floorRow:int = -1;

        /** Whether it has a floor: a most level contact. */
        public function get hasFloor():Boolean
        {
            return floorRow >= 0;
        }
    }
}
