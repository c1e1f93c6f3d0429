package starlogo.intersection.sweep
{
    import starlogo.convex.RelativeMotion;

    /**
     * Two boxes, as a record: where box b is at time 0 as seen from box a, how it moves until time 1, and the time of impact that BoxSweep writes. All
     * numbers are in the axes of a. Many pairs of boxes may have the same axes and motion. Then these are set once for all of them. Tests of boxes
     * that stand use no more than the axes, the vector and the half-extents.
     *
     * @private
     */
    public final class BoxPair
    {
        /** The axes of b. */
        public var axes:BoxAxes = new BoxAxes();

        /** The motion of b from time 0 to 1 as seen from a. */
        public var motionX:Number = 0;
        public var motionY:Number = 0;
        public var motionZ:Number = 0;

        /** The gap across which the boxes still touch: the sum of the margins (see Touching). */
        public var margin:Number = 0;

        /** The vector from a's middle to b's at time 0. */
        public var x:Number = 0;
        public var y:Number = 0;
        public var z:Number = 0;

        /** The half-extents of a. */
        public var aX:Number = 0;
        public var aY:Number = 0;
        public var aZ:Number = 0;

        /** The half-extents of b. */
        public var bX:Number = 0;
        public var bY:Number = 0;
        public var bZ:Number = 0;

        /** The latest time that counts: see RelativeMotion. */
        public var latest:Number = 1;

        /** The result: the time from which the axes that were tried do not separate the boxes, or RelativeMotion.NEVER. */
        public var time:Number = RelativeMotion.NEVER;
    }
}
