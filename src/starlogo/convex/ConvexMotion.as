package starlogo.convex
{
    /**
     * A straight motion of the first shape while the second stands still, as a record. Shapes are set where they stand. So the motion may begin
     * elsewhere.
     *
     * @private
     */
    public final class ConvexMotion
    {
        /** The time of shapes that do not touch. */
        public static const NEVER:Number = Infinity;

        /** The vector from where the shape was set to where it is at time 0. */
        public var startX:Number = 0;
        public var startY:Number = 0;
        public var startZ:Number = 0;

        /** The vector from where the shape is at time 0 to where it is at time 1. */
        public var x:Number = 0;
        public var y:Number = 0;
        public var z:Number = 0;

        /** A time before which the shapes certainly do not touch; 0 if none is known. A search that begins there takes fewer steps. */
        public var earliest:Number = 0;

        /** The latest time that counts, from 0 to 1. */
        public var latest:Number = 1;

        /** The time at which the shapes first touch, or NEVER. The contact is found at this time. */
        public var time:Number = 0;
    }
}
