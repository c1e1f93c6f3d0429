package starlogo.queries
{
    import starlogo.agents.Agent;
    import starlogo.engine;

    use namespace engine;

    /**
     * Lists the agents whose rows a search has found: in the order of distance, without those that a filter's <code>accepts</code> refuses. That
     * is asked when the search is over, so that it may ask questions of its own.
     *
     * @private
     */
    public final class Answers
    {
        private var _seen:SeenAgents;

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
         * @param found gets sorted
         * @param filter of which accepts has not been asked yet; null for none
         * @param out takes the list; null for a new one
         * @return out
         */
        public function list(found:FoundRows, filter:AgentFilter, out:Vector.<Agent>):Vector.<Agent>
        {
            var listed:Vector.<Agent> = out || new Vector.<Agent>();
            found.sort();
            if (filter == null || filter.accepts == null)
            {
                write(found, 0, listed);
                return listed;
            }
            var accepted:Vector.<Agent> = keepAccepted(found, 0, filter.accepts, FoundRows.ALL);
            shorten(listed, accepted.length);
            for (var i:int = 0; i < accepted.length; i++)
            {
                listed[i] = accepted[i];
            }
            shorten(accepted, 0);
            return listed;
        }

        /**
         * Asks of agents that a search has found, in their order, whether they are accepted.
         *
         * @param found has their rows
         * @param first how many of the first are not asked
         * @param accepts decides
         * @param most when so many are accepted no more are asked
         * @return those that are accepted; overwritten by the next call
         */
        public function keepAccepted(found:FoundRows, first:int, accepts:Function, most:int):Vector.<Agent>
        {
            if (_seen.asking == _asked.length)
            {
                _asked.push(new Vector.<Agent>());
            }
            var asked:Vector.<Agent> = _asked[_seen.asking];
            write(found, first, asked);
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

        private function write(found:FoundRows, first:int, out:Vector.<Agent>):void
        {
            var agents:Vector.<Agent> = _seen.table.agents;
            var rows:Vector.<int> = found.rows;
            var count:int = found.count;
            shorten(out, count - first);
            for (var i:int = first; i < count; i++)
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
