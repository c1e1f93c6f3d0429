package starlogo.broadphase
{
    /**
     * The cells of one width. Cells are squares of the ground. A cell's number is a hash of its column and its line.
     *
     * @private
     */
    public final class BinLevel
    {
        // A level is used up to this many widths from the origin. At that distance a position is rounded to 2^-29 of a width, and shapes within
        // 2^-20 of a width touch.
        internal static const MAX_DISTANCE:Number = 1 << 24;

        private static const SLACK:Number = 1 / (1 << 18);

        // The mask of a level without cells. No level with cells has it, because that has 32 cells at least.
        private static const NO_CELLS:int = 0;

        // The index among all levels. Extents that fit the level store it.
        internal var index:int;

        // A power of two, in patches. The widest members are at most this wide. No member is narrower than half of it, unless it is far
        // out or the level is the finest. Cells are a little wider. So two members that touch are in the same cell or in neighbouring cells.
        internal var width:Number;
        internal var cellsPerPatch:Number;

        // The square of the largest distance from the world's origin at which the level can be used. It is a field because V8 makes an object for
        // each Number that is returned.
        internal var maxDistanceSquared:Number;

        /**
         * Two extents may be this far apart, in patches, and still be a pair. Rounding errors are smaller, up to MAX_DISTANCE
         * widths from the origin.
         */
        public var slack:Number;

        // the number of members in the last search, and in CellLists since; and the index of the first cell's counter
        internal var count:int;
        internal var base:int;

        // The number of a cell is its line times stride plus its column. Only the bits in the mask count. It is NO_CELLS if the lists of
        // cells have no cells of the level.
        internal var mask:int = NO_CELLS;
        internal var stride:int;

        /**
         * @param index the index among all levels
         * @param width a power of two
         */
        public function BinLevel(index:int, width:Number)
        {
            this.index = index;
            this.width = width;
            cellsPerPatch = 1 / (width + 4 * width * SLACK);
            maxDistanceSquared = width * width * MAX_DISTANCE * MAX_DISTANCE;
            slack = width * SLACK;
        }

        /**
         * Assigns counters to the cells.
         *
         * @param base the number of counters of other levels
         * @return the number of counters including this level's
         */
        public function makeRoom(base:int):int
        {
            mask = maskFor(count);
            var bits:int = 0;
            while (1 << bits <= mask)
            {
                bits++;
            }
            // The stride is odd and about the square root of the number of cells. So neighbouring cells, and all cells of a compact world,
            // get different numbers.
            stride = (1 << ((bits + 1) >> 1)) + 1;
            this.base = base;
            return end + Bins.COPIED;
        }

        /** The index after the last cell's counter. The counters of the first cells are repeated from there on. */
        public function get end():int
        {
            return base + mask + 1;
        }

        /** Whether the lists of cells have cells of the level. */
        public function get hasCells():Boolean
        {
            return mask != NO_CELLS;
        }

        /** Gives up the cells. */
        public function dropCells():void
        {
            mask = NO_CELLS;
        }

        /** Whether the level would get as many cells as it has, for the members that it has now. */
        public function areCellsValid():Boolean
        {
            return count == 0 || maskFor(count) == mask;
        }

        // The mask for a number of members.
        private static function maskFor(members:int):int
        {
            // at least 32 cells, so that cells near each other never share a number
            var cells:int = 32;
            while (cells < members)
            {
                cells *= 2;
            }
            return cells - 1;
        }

        /** The column of cells at an x, or the line of cells at a y. */
        public function columnOf(place:Number):int
        {
            return place * cellsPerPatch + Bins.BIAS;
        }

        /** The number of the cell in a column and a line. */
        public function cellIn(column:int, line:int):int
        {
            return ((line & mask) * stride + column) & mask;
        }

        /** The number of the cell at a place. */
        public function cellAt(x:Number, y:Number):int
        {
            return cellIn(columnOf(x), columnOf(y));
        }

        /** Whether cells can be at or near a place. Farther out than <code>BIAS / 2</code> widths along x or y there are none. */
        public function isWithin(x:Number, y:Number):Boolean
        {
            var farthest:Number = width * (Bins.BIAS / 2);
            return x < farthest && x > -farthest && y < farthest && y > -farthest;
        }
    }
}
