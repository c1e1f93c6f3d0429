package starlogo.broadphase
{
    /**
     * The cells of one width. Cells are squares of the ground. Their columns and lines are hashed: the members of a cell are in a bucket, which cells
     * far from each other may share.
     *
     * @private
     */
    public final class BinLevel
    {
        // The width of the finest level, for points too. It is used up to 256 patches from the origin, so points of SpaceLand need no coarser level.
        // A power of two.
        internal static const MIN_WIDTH:Number = 1 / (1 << 16);

        // A level is used up to this many widths from the origin, and for places up to this many widths from the middle. So a place is at most twice
        // as far from the origin. At that distance a position is rounded to 2^-28 of a width, and shapes within 2^-20 of a width touch.
        internal static const MAX_DISTANCE:Number = 1 << 24;

        // Added to the number of a column or a line, so that it is positive and the conversion to int rounds down. BIAS is even, and larger than
        // MAX_DISTANCE.
        internal static const BIAS:Number = 1 << 26;

        private static const SLACK:Number = 1 / (1 << 18);

        /** In place of a level: its slack is infinite, so no extents are too far apart. */
        public static const ANY_GAP:BinLevel = new BinLevel(Infinity);

        // A level with buckets has 32 at least. So cells near each other never share one.
        private static const MIN_BITS:int = 5;

        /** The buckets of so many cells beside each other are one run. */
        internal static const RUN:int = 3;

        /** So many first buckets of a level are copied after its last one, so that the neighbours of the last cells are in one run too. */
        internal static const COPIED:int = RUN - 1;

        // A power of two, in patches. The widest members are at most this wide. No member is narrower than half of it, unless it is far
        // out or the level is the finest.
        internal var width:Number;

        // The reciprocal of the width of cells. Cells are a little wider than members. So two members that touch are in the same cell or in
        // neighbouring cells.
        internal var cellsPerPatch:Number;

        /**
         * Two extents may be this far apart, in patches, and still be a pair. Rounding errors are smaller, up to MAX_DISTANCE
         * widths from the origin.
         */
        public var slack:Number;

        // The number of members in the last search.
        internal var count:int;

        // The index of the level's first bucket.
        internal var firstBucket:int;

        // The bucket of a cell is its line times stride plus its column, counted from the first bucket. Only the bits in the mask count.
        internal var mask:int;
        internal var stride:int;

        /** @param width a power of two */
        public function BinLevel(width:Number)
        {
            this.width = width;
            cellsPerPatch = 1 / (width + 4 * width * SLACK);
            slack = width * SLACK;
        }

        /**
         * Gives the level as many buckets as its members need; none if it has no members.
         *
         * @param first the number of buckets of other levels
         * @return the number of buckets including this level's, and the copies of its first ones
         */
        public function layOutBuckets(first:int):int
        {
            if (count == 0)
            {
                return first;
            }
            var bits:int = MIN_BITS;
            while (1 << bits < count)
            {
                bits++;
            }
            mask = (1 << bits) - 1;
            // The stride is odd and about the square root of the number of buckets. So neighbouring cells, and all cells of a compact world,
            // get different buckets.
            stride = (1 << ((bits + 1) >> 1)) + 1;
            firstBucket = first;
            return endBucket + COPIED;
        }

        /** The index after the level's last bucket. Copies of the first buckets follow from there on. */
        public function get endBucket():int
        {
            return firstBucket + mask + 1;
        }

        /** Whether the level has got buckets in the last search: it had members. */
        public function get hasBuckets():Boolean
        {
            return count > 0;
        }

        /** The coarser one of this level and another. */
        public function coarserOf(other:BinLevel):BinLevel
        {
            return other.width > width ? other : this;
        }

        /** The column of cells at an x, or the line of cells at a y. */
        public function cellIndexAt(coordinate:Number):int
        {
            return coordinate * cellsPerPatch + BIAS;
        }

        /** The bucket of the cell in a column and a line. */
        public function bucketOf(column:int, line:int):int
        {
            return firstBucket + (((line & mask) * stride + column) & mask);
        }

        /** The bucket of the cell at a place. */
        public function bucketAt(x:Number, y:Number):int
        {
            return bucketOf(cellIndexAt(x), cellIndexAt(y));
        }

        /** Whether cells can be at or near a place. Farther out than <code>BIAS / 2</code> widths along x or y there are none. */
        public function isWithin(x:Number, y:Number):Boolean
        {
            var farthest:Number = width * (BIAS / 2);
            return x < farthest && x > -farthest && y < farthest && y > -farthest;
        }
    }
}
