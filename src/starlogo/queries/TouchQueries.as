package starlogo.queries
{
    import starlogo.agents.Agent;
    import starlogo.engine;
    import starlogo.search.AgentTable;
    import starlogo.search.Body;
    import starlogo.search.ListedAgents;

    use namespace engine;

    /**
     * Answers which agents a body touches.
     *
     * @private
     */
    public final class TouchQueries
    {
        private var _set:QuerySet;

        /** @param questions what questions work with */
        public function TouchQueries(questions:QuerySet)
        {
            _set = questions;
        }

        /**
         * Finds the agents that touch a body. They are sorted by the distances of their places from the body's place.
         *
         * @param asker the agent that asks, which is left out; or null
         * @param body the body that asks. While its model is loading it touches nothing
         * @param wanted Collector.ALL; or 1 for any agent that touches
         * @param filter the agents that count; null for all
         * @return has the answer
         */
        public function touching(asker:Agent, body:Body, wanted:int, filter:AgentFilter):Collector
        {
            var table:AgentTable = _set.seen.table;
            var answer:Collector = _set.found;
            var search:SweptBoxSearch = _set.boxSearch;
            answer.begin(wanted, Infinity, asker, filter);
            if (body.shape == null)
            {
                return answer;
            }
            _set.seen.beginWay(search, body);
            // if one row is wanted, it may be any that touches
            for (var other:int = answer.nextOf(search); other >= 0 && !answer.hasAny; other = answer.nextOf(search))
            {
                if (_set.seen.narrowPhase.areTouching(body, table.bodyOf(other)))
                {
                    var toX:Number = table.places.now.x[other] - body.placement.x;
                    var toY:Number = table.places.now.y[other] - body.placement.y;
                    var toZ:Number = table.places.now.z[other] - body.placement.z;
                    // the ground has no place, so it comes last
                    answer.add(other, other == ListedAgents.GROUND ? Infinity : toX * toX + toY * toY + toZ * toZ);
                }
            }
            return answer;
        }
    }
}
