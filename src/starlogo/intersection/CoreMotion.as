package starlogo.intersection
{
    /**
     * Where the core of a structure is as seen from the core of another one, and how it moves, as a record. The numbers are in the axes of a GapFinder.
     *
     * @private
     */
    public final class CoreMotion
    {
        /** The place at time 0. */
        public var x:Number = 0;
        public var y:Number = 0;
        public var z:Number = 0;

        /** How far it moves from there until time 1. */
        public var motionX:Number = 0;
        public var motionY:Number = 0;
        public var motionZ:Number = 0;

        /** The time of the gap that is found next. */
        public var time:Number = 0;
    }
}
