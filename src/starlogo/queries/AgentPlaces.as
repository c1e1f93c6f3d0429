package starlogo.queries
{
    import flash.geom.Vector3D;
    import starlogo.agents.Agent;
    import starlogo.data.requireGiven;
    import starlogo.engine;
    import starlogo.geometry.requireInWorld;
    import starlogo.queries.trees.Collector;
    import starlogo.queries.trees.Cone;
    import starlogo.queries.trees.NearSearch;

    use namespace engine;

    /**
     * Answers which agents are near, for games that load no other questions. The rules for all questions are at AgentQueries.
     */
    public final class AgentPlaces
    {
        // The square of a computed distance and a computed square of it differ by some rounding errors. A radius reaches as far as the game computes it.
        private static const SQUARE_ROUNDING:Number = 1 + 2e-15;

        private var _seen:SeenAgents;

        // The search of a question.
        private var _searchPool:NestedPool;

        // The cone of inCone, which calls accepts only after the search.
        private var _cone:Cone = new Cone();

        /**
         * Asks about the agents of a SeenAgents. Others may ask about the same.
         *
         * @param seen the agents that the questions see
         * @throws ArgumentError if it is null
         */
        public function AgentPlaces(seen:SeenAgents)
        {
            requireGiven("seen", seen);
            _seen = seen;
            _searchPool = new NestedPool(seen, NearSearch);
        }

        /**
         * Lists the agents near an agent.
         *
         * @param agent the agent in the middle
         * @param radius the largest distance in patches, not negative; may be Infinity
         * @param filter the agents that count; null for all
         * @param out receives the list; null for a new list
         * @return out, or the new list
         * @throws ArgumentError if the agent is null
         * @throws RangeError if the radius is negative or not a number
         */
        public function near(agent:Agent, radius:Number, filter:AgentFilter = null, out:Vector.<Agent> = null):Vector.<Agent>
        {
            return aroundAgent(agent, radius, Collector.ALL, filter).find().endWithList(out);
        }

        /**
         * Counts the agents near an agent. It throws the errors of <code>near()</code>.
         *
         * @param agent the agent in the middle
         * @param radius the largest distance in patches
         * @param filter the agents that count; null for all
         */
        public function countNear(agent:Agent, radius:Number, filter:AgentFilter = null):int
        {
            return aroundAgent(agent, radius, Collector.ALL, filter).count();
        }

        /**
         * The agent nearest to an agent: the first one in the list of <code>near()</code>. This question takes less time, because it does not
         * make the list.
         *
         * @param agent the agent that asks
         * @param radius the largest distance in patches
         * @param filter the agents that count; null for all
         * @return null if there is none
         */
        public function nearest(agent:Agent, radius:Number = Infinity, filter:AgentFilter = null):Agent
        {
            return aroundAgent(agent, radius, 1, filter).find().endWithFirst();
        }

        /**
         * Lists the agents nearest to an agent: the first ones in the list of <code>near()</code>. This question takes less time, because it
         * does not make the whole list.
         *
         * @param agent the agent that asks
         * @param count the largest number of agents in the list
         * @param radius the largest distance in patches
         * @param filter the agents that count; null for all
         * @param out receives the list; null for a new list
         * @return out, or the new list
         * @throws ArgumentError if the agent is null
         * @throws RangeError if count or radius is negative or not a number
         */
        public function nearestFew(agent:Agent, count:int, radius:Number = Infinity, filter:AgentFilter = null, out:Vector.<Agent> = null):Vector.<Agent>
        {
            requireNotNegative("count", count);
            return aroundAgent(agent, radius, count, filter).find().endWithList(out);
        }

        /**
         * Lists the agents near a point. It works like <code>near()</code>, but measures distances from the point.
         *
         * @param point in the world
         * @param radius the largest distance in patches
         * @param filter the agents that count; null for all
         * @param out receives the list; null for a new list
         * @return out, or the new list
         */
        public function nearPoint(point:Vector3D, radius:Number, filter:AgentFilter = null, out:Vector.<Agent> = null):Vector.<Agent>
        {
            return aroundPoint(point, radius, Collector.ALL, filter).find().endWithList(out);
        }

        /**
         * Counts the agents near a point. It works like <code>countNear()</code>, but measures distances from the point.
         *
         * @param point in the world
         * @param radius the largest distance in patches
         * @param filter the agents that count; null for all
         */
        public function countNearPoint(point:Vector3D, radius:Number, filter:AgentFilter = null):int
        {
            return aroundPoint(point, radius, Collector.ALL, filter).count();
        }

        /**
         * The agent nearest to a point. It works like <code>nearest()</code>, but measures distances from the point.
         *
         * @param point in the world
         * @param radius the largest distance in patches
         * @param filter the agents that count; null for all
         * @return null if there is none
         */
        public function nearestToPoint(point:Vector3D, radius:Number = Infinity, filter:AgentFilter = null):Agent
        {
            return aroundPoint(point, radius, 1, filter).find().endWithFirst();
        }

        /**
         * Lists the agents in a cone in front of an agent. The cone's axis is the x axis of the agent's rotation, including its pitch. Agents at
         * the same place as the agent are in every cone.
         *
         * @param agent the agent at the cone's tip
         * @param radius the largest distance in patches
         * @param degrees the full angle of the cone, not negative: half of it lies on either side of the axis. From 360 on, the answer is the
         *     same as that of near()
         * @param filter the agents that count; null for all
         * @param out receives the list; null for a new list
         * @return out, or the new list
         * @throws ArgumentError if the agent is null
         * @throws RangeError if the radius or the angle is negative or not a number
         */
        public function inCone(agent:Agent, radius:Number, degrees:Number, filter:AgentFilter = null, out:Vector.<Agent> = null):Vector.<Agent>
        {
            requireNotNegative("degrees", degrees);
            var search:NearSearch = aroundAgent(agent, radius, Collector.ALL, filter);
            var cone:Cone = degrees < 360 ? _cone.setTo(agent.freshPlacement(), degrees / 2) : null;
            return search.find(cone).endWithList(out);
        }

        private function aroundAgent(agent:Agent, radius:Number, maxCount:int, filter:AgentFilter):NearSearch
        {
            _seen.requirePlaced(agent);
            return begin(agent, agent.x, agent.y, agent.z, radius, maxCount, filter);
        }

        private function aroundPoint(point:Vector3D, radius:Number, maxCount:int, filter:AgentFilter):NearSearch
        {
            requireGiven("point", point);
            requireInWorld("a point", point.x, point.y, point.z);
            return begin(null, point.x, point.y, point.z, radius, maxCount, filter);
        }

        // Begins the search of a question around a place, without the agent that asks, which may be null.
        private function begin(asker:Agent, x:Number, y:Number, z:Number, radius:Number, maxCount:int, filter:AgentFilter):NearSearch
        {
            requireNotNegative("radius", radius);
            var search:NearSearch = NearSearch(_searchPool.current);
            return search.begin(_seen.beginCollecting(maxCount, SQUARE_ROUNDING * radius * radius, asker, filter), x, y, z);
        }
    }
}
