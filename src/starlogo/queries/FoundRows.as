package starlogo.queries
{
    import starlogo.agents.Agent;
    import starlogo.engine;
    import starlogo.search.KeyOrder;

    use namespace engine;

    /**
     * Collects the rows that a question finds: all rows, some of the nearest, only the nearest one, or only their number. Then it lists the
     * rows' agents, sorted by distance, without agents that the filter's <code>accepts</code> refuses.
     *
     * <p>It calls <code>accepts</code> after the search has ended, so <code>accepts</code> may ask questions itself.</p>
     *
     * @private
     */
    public final class FoundRows
    {
        /** A value of <code>most</code>: all rows are wanted. */
        public static const ALL:int = int.MAX_VALUE;

        /** A value of <code>most</code>: only the number of rows is wanted. */
        public static const NUMBER:int = -1;

        /** The rows that were found. */
        public var rows:Vector.<int> = new Vector.<int>();

        /** The squared distance of each row. */
        public var squares:Vector.<Number> = new Vector.<Number>();

        /** The number of rows that were found. */
        public var count:int = 0;

        /** The number of rows that are wanted, or ALL, or NUMBER. */
        public var most:int = ALL;

        /** The square of the largest distance at which rows are still wanted. */
        public var limit:Number = Infinity;

        /** Tests whether a row passes the filter; null if all rows do. */
        public var test:FilteredRows = null;

        /** The cone that rows must be in too; null for none. */
        public var cone:Cone = null;

        /** A row that is left out, or -1. */
        public var skipped:int = -1;

        /** By row: the index of its agent in the list. If two rows have the same distance, the one with the smaller index comes first. */
        public var ranks:Vector.<int>;

        private var _seen:SeenAgents;
        private var _filtered:FilteredRows;
        private var _accepts:Function = null;
        private var _order:KeyOrder = new KeyOrder();

        // When this number of rows is reached, only the nearest of them are kept.
        private var _room:int = ALL;

        // The agents that accepts is called for, by the number of questions under way, because accepts may ask questions itself.
        private var _asked:Vector.<Vector.<Agent>> = new Vector.<Vector.<Agent>>();

        /** @param seen the agents that questions are about */
        public function FoundRows(seen:SeenAgents)
        {
            _seen = seen;
            _filtered = new FilteredRows(seen);
        }

        /**
         * Begins a search.
         *
         * @param most how many of the nearest rows are wanted, or ALL, or NUMBER
         * @param limit the square of the largest distance
         * @param asker the agent that asks, which does not count; or null
         * @param filter the agents that count; null for all
         */
        public function begin(most:int, limit:Number, asker:Agent, filter:AgentFilter):void
        {
            this.most = most;
            this.limit = limit;
            skipped = asker == null ? -1 : _seen.table.rowOf(asker);
            test = filter == null ? null : _filtered.of(filter);
            _accepts = filter == null ? null : filter.accepts;
            cone = null;
            ranks = _seen.table.ranks;
            count = 0;
            _room = most < 1 || most > ALL / 2 ? ALL : 2 * most;
        }

        /**
         * How many rows a search has to find if this many are wanted. If a filter's <code>accepts</code> may refuse some, it has to find all.
         */
        public static function toFind(most:int, filter:AgentFilter):int
        {
            return filter == null || filter.accepts == null ? most : ALL;
        }

        /** Whether a row counts: it passes the filter and is not the skipped row. */
        public function wants(row:int):Boolean
        {
            return row != skipped && (test == null || test.accepts(row));
        }

        /** Adds a row. Its distance must not be beyond the limit. This may lower the limit. */
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

        /** Sorts the rows by distance. It drops rows beyond the number that is wanted. */
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
         * Lists the agents that <code>accepts</code> does not refuse, sorted by distance.
         *
         * @param out receives the list; null for a new list
         * @return out, or the new list
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

        /** The number of rows that <code>accepts</code> does not refuse. It begins with the nearest, and counts to this number at most. */
        public function countAccepted(most:int):int
        {
            if (_accepts == null)
            {
                return count;
            }
            sort();
            return keepAccepted(0, most).length;
        }

        /**
         * Calls <code>accepts</code> for the agents, in the order of the rows. <code>accepts</code> may ask questions that use this object
         * again.
         *
         * @param first how many rows to leave out at the beginning
         * @param most the number of accepted agents after which it stops
         * @return the accepted agents. The next call overwrites the list
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

        // Keeps only the accepted agents in the list.
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

        /** Makes a list shorter. It removes one element at a time, because V8 frees an array's memory if its length is set to less. */
        public static function shorten(list:Vector.<Agent>, length:int):void
        {
            while (list.length > length)
            {
                list.pop();
            }
        }
    }
}
