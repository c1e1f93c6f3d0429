package starlogo.queries
{
    import flash.geom.Vector3D;
    import starlogo.agents.Agent;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.geometry.requireGiven;

    use namespace engine;

    /**
     * Answers which agents are near: the questions of AgentQueries about places, for games that load no others. Their rules stand there.
     */
    public final class AgentPlaces
    {
        private var _world:QueryWorld;

        // By the number of questions under way that call accepts.
        private var _sets:Vector.<PlaceQueries> = new Vector.<PlaceQueries>();

        /**
         * Asks about the agents of a SeenAgents. Others may ask about the same.
         *
         * @param seen the agents that the questions see
         * @throws ArgumentError if it is null
         */
        public function AgentPlaces(seen:SeenAgents)
        {
            requireGiven("seen", seen);
            _world = seen.world;
        }

        /** See AgentQueries.near. It has the same arguments and the same answer. */
        public function near(agent:Agent, radius:Number, filter:AgentFilter = null, out:Vector.<Agent> = null):Vector.<Agent>
        {
            var at:Placement = _world.placeOf(agent);
            return ask.near(agent, at.x, at.y, at.z, radius, Collector.ALL, filter).list(out);
        }

        /** See AgentQueries.countNear. It has the same arguments and the same answer. */
        public function countNear(agent:Agent, radius:Number, filter:AgentFilter = null):int
        {
            var at:Placement = _world.placeOf(agent);
            return ask.countNear(agent, at.x, at.y, at.z, radius, filter);
        }

        /** See AgentQueries.nearest. It has the same arguments and the same answer. */
        public function nearest(agent:Agent, radius:Number = Infinity, filter:AgentFilter = null):Agent
        {
            var at:Placement = _world.placeOf(agent);
            return ask.near(agent, at.x, at.y, at.z, radius, 1, filter).firstAgent();
        }

        /** See AgentQueries.nearestFew. It has the same arguments and the same answer. */
        public function nearestFew(agent:Agent, count:int, radius:Number = Infinity, filter:AgentFilter = null, out:Vector.<Agent> = null):Vector.<Agent>
        {
            QuerySet.requireNotNegative("count", count);
            var at:Placement = _world.placeOf(agent);
            return ask.near(agent, at.x, at.y, at.z, radius, count, filter).list(out);
        }

        /** See AgentQueries.nearPoint. It has the same arguments and the same answer. */
        public function nearPoint(point:Vector3D, radius:Number, filter:AgentFilter = null, out:Vector.<Agent> = null):Vector.<Agent>
        {
            requirePoint(point);
            return ask.near(null, point.x, point.y, point.z, radius, Collector.ALL, filter).list(out);
        }

        /** See AgentQueries.countNearPoint. It has the same arguments and the same answer. */
        public function countNearPoint(point:Vector3D, radius:Number, filter:AgentFilter = null):int
        {
            requirePoint(point);
            return ask.countNear(null, point.x, point.y, point.z, radius, filter);
        }

        /** See AgentQueries.nearestToPoint. It has the same arguments and the same answer. */
        public function nearestToPoint(point:Vector3D, radius:Number = Infinity, filter:AgentFilter = null):Agent
        {
            requirePoint(point);
            return ask.near(null, point.x, point.y, point.z, radius, 1, filter).firstAgent();
        }

        /** See AgentQueries.inCone. It has the same arguments and the same answer. */
        public function inCone(agent:Agent, radius:Number, degrees:Number, filter:AgentFilter = null, out:Vector.<Agent> = null):Vector.<Agent>
        {
            QuerySet.requireNotNegative("degrees", degrees);
            var at:Placement = _world.placeOf(agent);
            return ask.near(agent, at.x, at.y, at.z, radius, Collector.ALL, filter, degrees).list(out);
        }

        private function get ask():PlaceQueries
        {
            // other questions may be under way
            while (_world.asking >= _sets.length)
            {
                _sets.push(new PlaceQueries(new QuerySet(_world)));
            }
            return _sets[_world.asking];
        }
    }
}
