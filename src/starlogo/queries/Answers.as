package starlogo.queries
{
    import starlogo.agents.Agent;
    import starlogo.engine;

    use namespace engine;

    /**
     * Makes the answer of what a search has found: in the order of distance, without the agents that a filter's <code>accepts</code> refuses. That
     * is asked when the search is over, so that it may ask questions of its own.
     *
     * @private
     */
    public final class Answers
    {
        private var _seen:SeenAgents;
        private var _order:DistanceOrder = new DistanceOrder();

        // By how many questions are under way: the agents that accepts is asked of.
        private var _asked:Vector.<Vector.<Agent>> = new Vector.<Vector.<Agent>>();

        /** @param seen the agents that are asked about */
        public function Answers(seen:SeenAgents)
        {
            _seen = seen;
        }

        /**
         * Lists what a search has found.
         *
         * @param members what it has found; gets sorted
         * @param squares the squared distances of these
         * @param count how many
         * @param filter of which accepts has not been asked yet; null for none
         * @param out takes the list; null for a new one
         * @return out
         */
        public function list(members:Vector.<int>, squares:Vector.<Number>, count:int, filter:AgentFilter, out:Vector.<Agent>):Vector.<Agent>
        {
            var listed:Vector.<Agent> = out || new Vector.<Agent>();
            _order.sort(members, squares, count);
            if (filter == null || filter.accepts == null)
            {
                write(members, 0, count, listed);
                return listed;
            }
            var accepted:Vector.<Agent> = keepAccepted(members, 0, count, filter.accepts, int.MAX_VALUE);
            shorten(listed, accepted.length);
            for (var i:int = 0; i < accepted.length; i++)
            {
                listed[i] = accepted[i];
            }
            shorten(accepted, 0);
            return listed;
        }

        /** How many of those that a search has found are accepted; parameters as in list. */
        public function countAccepted(members:Vector.<int>, squares:Vector.<Number>, count:int, accepts:Function):int
        {
            _order.sort(members, squares, count);
            return keepAccepted(members, 0, count, accepts, int.MAX_VALUE).length;
        }

        /**
         * The first that is accepted of those that a search has found, or null.
         *
         * @param members what it has found; gets sorted
         * @param squares the squared distances of these
         * @param first how many, in the order of distance, are known to be refused
         * @param count how many there are
         * @param accepts decides
         */
        public function firstAccepted(members:Vector.<int>, squares:Vector.<Number>, first:int, count:int, accepts:Function):Agent
        {
            _order.sort(members, squares, count);
            var accepted:Vector.<Agent> = keepAccepted(members, first, count, accepts, 1);
            return accepted.length > 0 ? accepted[0] : null;
        }

        /**
         * Those that are accepted of some members, in their order.
         *
         * @param first how many are known to be refused
         * @param count how many there are
         * @param most when so many are accepted no more are asked
         * @return overwritten by the next call
         */
        public function keepAccepted(members:Vector.<int>, first:int, count:int, accepts:Function, most:int):Vector.<Agent>
        {
            if (_seen.asking == _asked.length)
            {
                _asked.push(new Vector.<Agent>());
            }
            var asked:Vector.<Agent> = _asked[_seen.asking];
            write(members, first, count, asked);
            _seen.asking++;
            try
            {
                ask(asked, accepts, most);
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

        private function write(members:Vector.<int>, first:int, count:int, out:Vector.<Agent>):void
        {
            var agents:Vector.<Agent> = _seen.table.agents;
            var rows:Vector.<int> = _seen.table.rows;
            shorten(out, count - first);
            for (var i:int = first; i < count; i++)
            {
                out[i - first] = agents[rows[members[i]]];
            }
        }

        // One by one: of an array whose length is set to less, V8 gives up the store.
        private static function shorten(list:Vector.<Agent>, length:int):void
        {
            while (list.length > length)
            {
                list.pop();
            }
        }
    }
}
