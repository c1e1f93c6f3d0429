package starlogo.queries.motion
{
    import flash.geom.Vector3D;
    import starlogo.agents.Agent;
    import starlogo.data.NumberList;
    import starlogo.engine;
    import starlogo.queries.AgentFilter;
    import starlogo.queries.SeenAgents;
    import starlogo.queries.trees.Collector;
    import starlogo.queries.trees.SweptBoxSearch;

    use namespace engine;

    /**
     * Finds the rows that may be in the way of a body that moves. <code>MovingBody.rows</code> receives them.
     *
     * @private
     */
    public final class ObstacleSearch
    {
        private var _seen:SeenAgents;
        private var _found:Collector;
        private var _search:SweptBoxSearch = new SweptBoxSearch();

        /** @param seen the agents that the questions are about */
        public function ObstacleSearch(seen:SeenAgents)
        {
            _seen = seen;
            _found = new Collector(seen);
        }

        /** Whether a filter's <code>accepts</code> is being called. Then this must not begin another search. */
        public function get isAsking():Boolean
        {
            return _found.isAsking;
        }

        /** Finds the rows near a straight motion of a body. The asker is the agent that moves, or null. */
        public function findAlong(body:MovingBody, motion:Vector3D, asker:Agent, filter:AgentFilter):void
        {
            if (begin(body))
            {
                _search.moveAlong(motion.x, motion.y, motion.z, 1);
                collectRows(asker, filter, body.rows);
            }
        }

        /**
         * Finds the rows near motions of a body that are not known yet.
         *
         * @param range how far it may go in any direction
         * @param up how much farther it may go upwards
         * @param down how much farther it may go downwards
         * @param asker the agent that moves
         */
        public function findWithin(body:MovingBody, range:Number, up:Number, down:Number, asker:Agent, filter:AgentFilter):void
        {
            if (begin(body))
            {
                _search.widen(range, up, down);
                collectRows(asker, filter, body.rows);
            }
        }

        /** Asks a filter about one row, as a search of its own. Returns whether the row counts. */
        public function askFilter(row:int, asker:Agent, filter:AgentFilter):Boolean
        {
            return _found.askFilter(row, asker, filter);
        }

        // Begins without rows. Returns false if the model of the body is loading.
        private function begin(body:MovingBody):Boolean
        {
            body.rows.count = 0;
            if (body.hasShape)
            {
                _search.beginAround(_seen.treeOfExtents(), body.source);
            }
            return body.hasShape;
        }

        private function collectRows(asker:Agent, filter:AgentFilter, out:NumberList):void
        {
            _found.begin(Collector.ALL, 1, asker, filter);
            for (var row:int = _found.nextOf(_search); row >= 0; row = _found.nextOf(_search))
            {
                _found.add(row, 0);
            }
            var count:int = _found.endSorted();
            for (var i:int = 0; i < count; i++)
            {
                out.add(_found.rowAt(i));
            }
        }
    }
}
