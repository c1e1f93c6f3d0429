package starlogo.queries
{
    import starlogo.search.KeyOrder;

    /**
     * Collects what a search finds: all rows, some of the nearest, the nearest alone, or only their number.
     *
     * @private
     */
    public final class FoundRows
    {
        /** In place of how many rows are wanted: all. */
        public static const ALL:int = int.MAX_VALUE;

        /** In place of how many rows are wanted: only their number counts. */
        public static const NUMBER:int = -1;

        /** The rows. */
        public var rows:Vector.<int> = new Vector.<int>();

        /** The squared distance of each. */
        public var squares:Vector.<Number> = new Vector.<Number>();

        /** How many there are. */
        public var count:int = 0;

        /** How many are wanted. */
        public var most:int = ALL;

        /** The square of the greatest distance at which more are wanted. */
        public var limit:Number = Infinity;

        /** Says which rows count; null for all. */
        public var test:RowTest = null;

        /** A row that does not count; or -1. */
        public var skipped:int = -1;

        /** By row: what decides between rows that are equally far, the less first. */
        public var ranks:Vector.<int>;

        private var _order:KeyOrder = new KeyOrder();

        // When so many are there the nearest of them are kept.
        private var _room:int = ALL;

        /** @param seen the agents whose rows these are */
        public function FoundRows(seen:SeenAgents)
        {
            ranks = seen.ranks;
        }

        /**
         * Begins a search.
         *
         * @param most how many rows are wanted, of the nearest; or ALL, or NUMBER
         * @param limit the square of the greatest distance
         * @param skipped a row that does not count; or -1
         * @param test says which others count; null for all
         */
        public function begin(most:int, limit:Number, skipped:int, test:RowTest):void
        {
            this.most = most;
            this.limit = limit;
            this.skipped = skipped;
            this.test = test;
            count = 0;
            _room = most < 1 || most > ALL / 2 ? ALL : 2 * most;
        }

        /** Whether a row counts. */
        public function wants(row:int):Boolean
        {
            return row != skipped && (test == null || test.accepts(row));
        }

        /** Takes a row that is not beyond the limit, which may become less by that. */
        public function add(row:int, square:Number):void
        {
            rows[count] = row;
            squares[count] = square;
            count++;
            if (count == _room)
            {
                sort();
            }
        }

        /** Puts the rows in the order of their distances, those that are equally far in the order of the list; more than are wanted are left out. */
        public function sort():void
        {
            _order.sort(rows, squares, count, ranks);
            if (count > most)
            {
                count = most;
                limit = most > 0 ? squares[most - 1] : 0;
            }
        }
    }
}
