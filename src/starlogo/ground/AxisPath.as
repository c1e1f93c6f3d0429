package starlogo.ground
{
    /** How the box of a GroundSearch moves along x or along y, as a record. */
    internal final class AxisPath
    {
        /** The box's middle at time 0, relative to the search's origin; and half its length, with a margin for rounding. */
        public var at:Number = 0;
        public var half:Number = 0;

        /** How far it moves from time 0 to time 1. */
        public var speed:Number = 0;

        /** Where the first cell begins, relative to the search's origin. */
        public var corner:Number = 0;
    }
}
