package starlogo.broadphase
{
    /** The cells of one width: squares of the ground, numbered by a hash of their column and row. */
    internal final class BinLevel
    {
        // How far from the origin a level reaches, in widths. There a position is rounded by 2^-29 of a width, and shapes touch across 2^-20 of
        // one.
        private static const REACH:Number = 1 << 24;

        private static const SLACK:Number = 1 / (1 << 18);

        // Extents that fit the level have this number.
        internal var number:int;

        // A power of two, in patches: as wide as the widest members, and less than twice as wide as any. Cells are a little wider, so that two
        // members that touch are in cells side by side, or in one.
        internal var width:Number;
        internal var cellsPerPatch:Number;

        // Half the larger side of a member's ground rectangle is at most this large, and larger than this, unless it is too far out for a finer
        // level.
        internal var largestHalf:Number;
        internal var tooSmallHalf:Number;

        // How far out the level reaches: the square of the distance from the world's origin.
        internal var reachSquared:Number;

        // How far apart two extents may be, in patches, and still be a pair: more than rounding comes to anywhere in reach.
        internal var slack:Number;

        // How many members there are in this search, and the number of the first cell's counter.
        internal var count:int;
        internal var base:int;

        // The cell at a column and row has the number row times stride plus column, of which the bits of the mask count.
        internal var mask:int;
        internal var stride:int;

        /**
         * @param number different from that of any other level
         * @param width a power of two
         */
        public function BinLevel(number:int, width:Number)
        {
            this.number = number;
            this.width = width;
            cellsPerPatch = 1 / (width + 4 * width * SLACK);
            largestHalf = width / 2;
            tooSmallHalf = width / 4;
            reachSquared = width * width * REACH * REACH;
            slack = width * SLACK;
        }

        /**
         * Makes room for the members.
         *
         * @param base the number of counters that others have
         * @return that number with its own
         */
        public function makeRoom(base:int):int
        {
            // at least 32 cells, so that those near each other never share a number
            var bits:int = 5;
            while ((1 << bits) < count)
            {
                bits++;
            }
            mask = (1 << bits) - 1;
            // odd, and about the square root: cells side by side, and a whole compact world, get numbers of their own
            stride = (1 << ((bits + 1) >> 1)) + 1;
            this.base = base;
            return base + mask + 1 + Bins.COPIED;
        }
    }
}
