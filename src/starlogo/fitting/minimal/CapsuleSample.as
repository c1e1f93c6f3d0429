package starlogo.fitting.minimal
{
    /** A capsule along some direction, that MinimalCapsuleFitter may go on from. */
    public final class CapsuleSample extends DirectionSample
    {
        /** Where the segment starts along the direction, seen from the plane through the origin. */
        public var low:Number;

        /** Where it ends. */
        public var high:Number;

        /** The ends, x, y, z of either. */
        public var ends:Vector.<Number>;

        /**
         * No capsule yet: of infinite volume.
         *
         * @param x of the direction
         * @param y of the direction
         * @param z of the direction
         */
        public function CapsuleSample(x:Number, y:Number, z:Number)
        {
            super(x, y, z);
        }
    }
}
