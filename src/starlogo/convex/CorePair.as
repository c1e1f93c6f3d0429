package starlogo.convex
{
    /**
     * A question about the cores of two shapes: a record that ConvexPair fills and the other classes of this room read.
     *
     * <p>The first shape is the one that comes first by its place, not the one that was asked about first. So rounding does not depend on the order
     * of the arguments.</p>
     */
    internal final class CorePair
    {
        /** The two shapes. */
        public var a:ConvexShape = null;
        public var b:ConvexShape = null;

        /** Whether b is the shape that was asked about first. */
        public var isSwapped:Boolean = false;

        /** The vector from b's origin to a's. */
        public var x:Number = 0;
        public var y:Number = 0;
        public var z:Number = 0;

        /** The motion of a. Of two displacements that are equally short, the one against it is taken. */
        public var motionX:Number = 0;
        public var motionY:Number = 0;
        public var motionZ:Number = 0;

        /** The distance of the cores up to which the shapes touch. */
        public var touchingDistance:Number = 0;

        /** A search for the distance may end when it knows that the cores are farther apart than this. */
        public var maxDistance:Number = Infinity;

        /**
         * The time that is left for the motion. A search may end when it knows that the shapes do not touch in this time. Infinity if the search is
         * for the distance.
         */
        public var timeLeft:Number = Infinity;
    }
}
