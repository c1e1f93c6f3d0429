package starlogo.queries.motion
{
    import flash.geom.Vector3D;
    import starlogo.convex.ContactPoint;

    /**
     * Where a straight motion of a body first touches a row. TouchSweep writes it.
     *
     * @private
     */
    public final class MotionResult
    {
        /** The place of the body at the end. */
        public var place:Vector3D = new Vector3D();

        /** The free part of the motion, from 0 to 1. */
        public var fraction:Number = 1;

        /** The row that stops it; -1 for none. */
        public var row:int = -1;

        /** The contact with that row. */
        public var contact:ContactPoint = new ContactPoint();

        /** Where the core of the body touches that row, if the fraction is not 0. */
        public var corePlace:Vector3D = new Vector3D();

        /** Whether it began deep in a row. */
        public var isDeep:Boolean = false;

        /** Whether it began with a lift out of a row. */
        public var isLifted:Boolean = false;
    }
}
