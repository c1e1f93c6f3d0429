package starlogo.ground
{
    /** Some columns and rows of the squares of a level, as a record. There is no square if a last one is before the first. */
    internal final class SquareRange
    {
        public var firstColumn:int = 0;
        public var lastColumn:int = 0;
        public var firstRow:int = 0;
        public var lastRow:int = 0;
    }
}
