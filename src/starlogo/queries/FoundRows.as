package starlogo.queries
{
    import starlogo.agents.Agent;
    import starlogo.engine;
    import starlogo.search.KeyOrder;

    use namespace engine;

    /**
     * Collects the rows that a question finds: all, some of the nearest, the nearest alone, or only their number. Then it lists their agents, sorted by
     * distance, without those that the filter's <code>accepts</code> refuses. <code>accepts</code> is asked when the search is over, so that it may ask
     * questions of its own.
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

        /** By row: where its agent is in the list. Of rows that are equally far, the first in the list comes first. */
        public var ranks:Vector.<int>;

        private var _seen:SeenAgents;
        private var _filtered:FilteredRows;
        private var _accepts:Function = null;
        private var _order:KeyOrder = new KeyOrder();

        // When so many are there the nearest of them are kept.
        private var _room:int = ALL;

        // By how many questions are under way: the agents that accepts is asked of.
        private var _asked:Vector.<Vector.<Agent>> = new Vector.<Vector.<Agent>>();

        /** @param seen the agents whose rows these are */
        public function FoundRows(seen:SeenAgents)
        {
            _seen = seen;
            ranks = seen.ranks;
            _filtered = new FilteredRows(seen);
        }

        /**
         * Begins a search.
         *
         * @param most how many rows are wanted, of the nearest; or ALL, or NUMBER
         * @param limit the square of the greatest distance
         * @param skipped a row that does not count; or -1
         * @param filter says which others count; null for all
         */
        public function begin(most:int, limit:Number, skipped:int, filter:AgentFilter):void
        {
            this.most = most;
            this.limit = limit;
            this.skipped = skipped;
            test = filter == null ? null : _filtered.of(filter);
            _accepts = filter == null ? null : filter.accepts;
            count = 0;
            _room = most < 1 || most > ALL / 2 ? ALL : 2 * most;
        }

        /** Whether a row counts. */
        public function wants(row:int):Boolean
        {
            return row != skipped && (test == null || test.accepts(row));
        }

        /** Takes a row that is not beyond the limit. The limit may become less by that. */
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

        /** Puts the rows in the order of their distances. More than are wanted are left out. */
        public function sort():void
        {
            _order.sort(rows, squares, count, ranks);
            if (count > most)
            {
                count = most;
                limit = most > 0 ? squares[most - 1] : 0;
            }
        }

        /**
         * Lists the agents, sorted, those that are accepted.
         *
         * @param out takes the list; null for a new one
         * @return out
         */
        public function list(out:Vector.<Agent>):Vector.<Agent>
        {
            var listed:Vector.<Agent> = out || new Vector.<Agent>();
            sort();
            if (_accepts == null)
            {
                write(0, listed);
                return listed;
            }
            var accepted:Vector.<Agent> = keepAccepted(0, ALL);
            shorten(listed, accepted.length);
            for (var i:int = 0; i < accepted.length; i++)
            {
                listed[i] = accepted[i];
            }
            shorten(accepted, 0);
            return listed;
        }

        /**
         * Asks <code>accepts</code> of the agents, in the order of the rows. It may ask questions that begin new searches with this.
         *
         * @param first how many of the first are not asked
         * @param most when so many are accepted no more are asked
         * @return those that are accepted; overwritten by the next call
         */
        public function keepAccepted(first:int, most:int):Vector.<Agent>
        {
            if (_seen.asking >= _asked.length)
            {
                _asked.length = _seen.asking + 1;
            }
            var asked:Vector.<Agent> = _asked[_seen.asking] ||= new Vector.<Agent>();
            write(first, asked);
            _seen.asking++;
            try
            {
                ask(asked, _accepts, most);
            }
            finally
            {
                _seen.asking--;
            }
            return asked;
        }

        // Leaves the accepted ones.
        private static function ask(asked:Vector.<Agent>, accepts:Function, most:int):void
        {
            var kept:int = 0;
            for (var i:int = 0; i < asked.length && kept < most; i++)
            {
                if (accepts(asked[i]))
                {
                    asked[kept] = asked[i];
                    kept++;
                }
            }
            shorten(asked, kept);
        }

        private function write(first:int, out:Vector.<Agent>):void
        {
            var agents:Vector.<Agent> = _seen.table.agents;
            var end:int = count;
            shorten(out, end - first);
            for (var i:int = first; i < end; i++)
            {
                out[int(i - first)] = agents[rows[i]];
            }
        }

        /** Makes a list shorter, one by one: of an array whose length is set to less, V8 gives up the store. */
        public static function shorten(list:Vector.<Agent>, length:int):void
        {
            while (list.length > length)
            {
                list.pop();
            }
        }
    }
}
