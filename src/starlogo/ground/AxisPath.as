package starlogo.ground
{
    /** How the box of a BoxPath moves along x or along y, as a record, so that one function serves both axes. All is relative to the search's origin. */
    internal final class AxisPath
    {
        /** The box's middle at time 0. */
        public var middle:Number = 0;

        /** How far the box reaches on both sides of its middle, and the slack. */
        public var reach:Number = 0;

        /** How far the box moves from time 0 to time 1. */
        public var speed:Number = 0;

        /** Where the cells of the ground begin, and the column or the row of the last one. */
        public var cellsBegin:Number = 0;
        public var lastCell:int = 0;
    }
}
