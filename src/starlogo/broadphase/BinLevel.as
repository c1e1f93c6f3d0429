package starlogo.broadphase
{
    /**
     * The bins of one width: a hash table of lists, one list a bin or, now and then, a few bins.
     *
     * @private
     */
    public final class BinLevel
    {
        /** How far out a level reaches, in bins. */
        public static const REACH:Number = 1 << 28;

        // At the reach a position is rounded by 2^-25 of a bin.
        private static const PADDING:Number = 1 / (1 << 20);

        /** The width of a bin, a power of two, in patches. */
        public var width:Number;

        /** Bins in a patch. */
        public var perWidth:Number;

        /** Its proxies are at most this large: half the larger side of the rectangle, a quarter of a bin. */
        public var largestHalf:Number;

        /** Its proxies are larger than this. */
        public var tooSmallHalf:Number;

        /**
         * How far out the level reaches: the square of the distance from the world's origin. Farther out a bin's
         * number would not fit an int, and rounding would be coarse beside a bin, in a height too.
         */
        public var reachSquared:Number;

        /**
         * How much wider a proxy's extents are made on each side, in patches: more than rounding comes to anywhere in
         * the level's reach, so that proxies that just touch share a bin. More makes more entries and candidates.
         */
        public var padding:Number;

        /** The first entry of each list, or null. */
        internal var heads:Vector.<BinEntry> = new Vector.<BinEntry>();

        /** The bin at a column and row has its list at row times stride plus column, of which these bits count. */
        public var mask:int;

        /** @copy #mask */
        public var stride:int;

        /** The proxies of this level. */
        public var proxies:Vector.<AgentProxy> = new Vector.<AgentProxy>();

        /** How many of them there are in this search. */
        public var count:int = 0;

        /** The proxies of the search before, unless they were released. */
        internal var previous:Vector.<AgentProxy> = new Vector.<AgentProxy>();

        /**
         * @param width a power of two
         */
        public function BinLevel(width:Number)
        {
            this.width = width;
            perWidth = 1 / width;
            largestHalf = width / 4;
            tooSmallHalf = width / 8;
            padding = width * PADDING;
            reachSquared = width * width * REACH * REACH;
        }

        /** Begins a search without proxies. */
        internal function clear():void
        {
            var other:Vector.<AgentProxy> = previous;
            previous = proxies;
            proxies = other;
            count = 0;
        }

        /** Releases the proxies of the search before. */
        internal function releasePrevious():void
        {
            release(previous);
        }

        /** Releases all proxies, those of a search that was not finished among them. */
        internal function releaseAll():void
        {
            release(previous);
            release(proxies);
            heads.length = 0;
            count = 0;
        }

        /** Empties the bins, with room for the proxies. */
        internal function clearBins():void
        {
            // those of other searches
            proxies.length = count;
            heads.length = 0;
            if (count == 0)
            {
                return;
            }
            // at least 64 lists, so that bins near each other never share one
            var bits:int = 6;
            while ((1 << bits) < 2 * count)
            {
                bits++;
            }
            mask = (1 << bits) - 1;
            // odd, and about the square root: bins side by side, and a whole compact world, get lists of their own
            stride = (1 << ((bits + 1) >> 1)) + 1;
            // the player clears a vector that shrinks and grows natively
            heads.length = 1 << bits;
        }

        // Takes proxies out of each other's lists: one that comes to no further search would keep those alive that it was in a
        // bin with.
        private static function release(proxies:Vector.<AgentProxy>):void
        {
            for (var i:int = proxies.length - 1; i >= 0; i--)
            {
                var first:BinEntry = proxies[i].entry;
                var entry:BinEntry = first;
                do
                {
                    entry.next = null;
                    entry = entry.sibling;
                }
                while (entry !== first);
            }
            proxies.length = 0;
        }
    }
}
