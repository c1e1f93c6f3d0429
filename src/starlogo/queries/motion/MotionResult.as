package starlogo.queries.motion
{
    import flash.geom.Vector3D;
    import starlogo.convex.ContactPoint;

    /**
     * How a motion of a body ends, a slide or a straight one, as a record. Slider, ShrunkSweep.findStop and TouchFinder write it.
     *
     * @private
     */
    public final class MotionResult
    {
        /** The place of the body at the end. */
        public var place:Vector3D = new Vector3D();

        /** The length of its way, as a fraction of the length of the motion, from 0 to 1. A straight motion counts up to the touch. */
        public var fraction:Number = 1;

        /** The row of the last wall that a slide met, a surface that was too steep for it; -1 if it met none. */
        public var wallRow:int = -1;

        /** The contact that it has met. A slide keeps the most level one: the one whose normal has the greatest z. */
        public var contact:ContactPoint = new ContactPoint();

        /** The row of that contact; -1 if it has met nothing, or a slide only what showed no contact (Impact.isNormalFallback). */
        public var row:int = -1;

        /** The place of the body where the shrunk body touches the row. A slide does not set it, nor a motion that a plane stops. */
        public var shrunkPlace:Vector3D = new Vector3D();

        /** Whether the body starts in an overlap for which a plane stands: a deep one, or one that pushes did not end. In TouchFinder it stops the body. */
        public var startsPenetrating:Boolean = false;

        /** Whether it has a contact. */
        public function get hasContact():Boolean
        {
            return row >= 0;
        }
    }
}
