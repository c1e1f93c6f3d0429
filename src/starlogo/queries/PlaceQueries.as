package starlogo.queries
{
    import starlogo.agents.Agent;
    import starlogo.engine;

    use namespace engine;

    /**
     * Answers which agents have their places near a point.
     *
     * @private
     */
    public final class PlaceQueries
    {
        private var _set:QuerySet;
        private var _near:NearSearch = new NearSearch();
        private var _count:CountSearch = new CountSearch();
        private var _cone:Cone = new Cone();

        /** @param questions what questions work with */
        public function PlaceQueries(questions:QuerySet)
        {
            _set = questions;
        }

        /**
         * Finds the agents near a place.
         *
         * @param asker the agent that asks, which is left out; or null
         * @param x the place
         * @param y the place
         * @param z the place
         * @param radius the largest distance
         * @param wanted how many of the nearest agents are wanted, or Collector.ALL
         * @param filter the agents that count; null for all
         * @param degrees the angle of a cone in front of the asker; from 360 on there is no cone
         * @return has the answer
         */
        public function near(asker:Agent, x:Number, y:Number, z:Number, radius:Number, wanted:int, filter:AgentFilter, degrees:Number = 360):Collector
        {
            QuerySet.requireNotNegative("radius", radius);
            _set.found.begin(wanted, radius * radius, asker, filter);
            var cone:Cone = degrees < 360 ? _cone.setTo(asker.worldPlacement(), degrees / 2) : null;
            _near.find(_set.seen.findPlaces(), x, y, z, _set.found, cone);
            return _set.found;
        }

        /** Counts the agents near a place. The parameters are those of <code>near()</code>. */
        public function countNear(asker:Agent, x:Number, y:Number, z:Number, radius:Number, filter:AgentFilter):int
        {
            if (filter != null && filter.accepts != null)
            {
                return near(asker, x, y, z, radius, Collector.ALL, filter).end();
            }
            QuerySet.requireNotNegative("radius", radius);
            _set.found.filter.begin(asker, filter);
            return _count.count(_set.seen.findPlaces(), x, y, z, radius * radius, _set.found.filter);
        }
    }
}
