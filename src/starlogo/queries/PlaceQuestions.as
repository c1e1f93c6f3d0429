package starlogo.queries
{
    import starlogo.agents.Agent;
    import starlogo.engine;
    import starlogo.geometry.Placement;

    use namespace engine;

    /**
     * Answers questions about the agents' places: which agents are near a place, and which are the nearest.
     *
     * @private
     */
    public final class PlaceQuestions
    {
        private var _seen:SeenAgents;
        private var _search:NearSearch = new NearSearch();
        private var _found:Collector;
        private var _cone:Cone = new Cone();

        /** @param seen the agents that questions are about */
        public function PlaceQuestions(seen:SeenAgents)
        {
            _seen = seen;
            _found = new Collector(seen);
        }

        /**
         * Lists the agents near a place.
         *
         * @param asker the agent that asks, which is left out; or null
         * @param x the place
         * @param y the place
         * @param z the place
         * @param radius the largest distance
         * @param wanted how many of the nearest agents are wanted, or Collector.ALL
         * @param filter the agents that count; null for all
         * @param out receives the list; null for a new list
         * @return out, or the new list
         */
        public function list(asker:Agent, x:Number, y:Number, z:Number, radius:Number, wanted:int, filter:AgentFilter, out:Vector.<Agent>):Vector.<Agent>
        {
            find(asker, x, y, z, radius, wanted, filter);
            return _found.list(out);
        }

        /** Counts the agents near a place. The parameters are those of <code>list()</code>. */
        public function count(asker:Agent, x:Number, y:Number, z:Number, radius:Number, filter:AgentFilter):int
        {
            requireRadius(radius);
            _found.beginCount(radius * radius, asker, filter);
            _search.find(_seen.findPlaces(), x, y, z, _found);
            return _found.end();
        }

        /** The agent nearest to a place, or null. The parameters are those of <code>list()</code>. */
        public function nearest(asker:Agent, x:Number, y:Number, z:Number, radius:Number, filter:AgentFilter):Agent
        {
            find(asker, x, y, z, radius, 1, filter);
            var row:int = _found.first();
            return row < 0 ? null : _seen.table.agents[row];
        }

        /** See AgentQueries.inCone. */
        public function inCone(agent:Agent, radius:Number, degrees:Number, filter:AgentFilter, out:Vector.<Agent>):Vector.<Agent>
        {
            if (!(degrees >= 0))
            {
                throw new RangeError("degrees must not be negative: " + degrees);
            }
            var at:Placement = _seen.placeOf(agent);
            find(agent, at.x, at.y, at.z, radius, Collector.ALL, filter, degrees);
            return _found.list(out);
        }

        private function find(asker:Agent, x:Number, y:Number, z:Number, radius:Number, wanted:int, filter:AgentFilter, degrees:Number = 360):void
        {
            requireRadius(radius);
            _found.begin(wanted, radius * radius, asker, filter);
            if (degrees < 360)
            {
                _found.cone = _cone.setTo(asker.worldPlacement(), degrees / 2, _seen.table);
            }
            _search.find(_seen.findPlaces(), x, y, z, _found);
        }

        private static function requireRadius(radius:Number):void
        {
            if (!(radius >= 0))
            {
                throw new RangeError("radius must not be negative: " + radius);
            }
        }
    }
}
