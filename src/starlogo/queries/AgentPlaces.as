package starlogo.queries
{
    import flash.geom.Vector3D;
    import starlogo.agents.Agent;
    import starlogo.data.requireGiven;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.queries.trees.Collector;
    import starlogo.queries.trees.Cone;
    import starlogo.queries.trees.NearSearch;

    use namespace engine;

    /**
     * Answers which agents are near: the questions of AgentQueries about places, for games that load no others. Their rules stand there.
     */
    public final class AgentPlaces
    {
        private var _seen:SeenAgents;
        private var _found:Collector;
        private var _near:NearSearch = new NearSearch();
        private var _cone:Cone = new Cone();

        // Answers what an accepts asks while these questions call it.
        private var _nested:AgentPlaces = null;

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
            _found = new Collector(seen);
        }

        /** See AgentQueries.near. It has the same arguments, answers and errors. */
        public function near(agent:Agent, radius:Number, filter:AgentFilter = null, out:Vector.<Agent> = null):Vector.<Agent>
        {
            return idle.findNear(agent, radius, Collector.ALL, filter).endWithList(out);
        }

        /** See AgentQueries.countNear. It has the same arguments, answers and errors. */
        public function countNear(agent:Agent, radius:Number, filter:AgentFilter = null):int
        {
            var at:Placement = _seen.placeOf(agent);
            return idle.count(agent, at.x, at.y, at.z, radius, filter);
        }

        /** See AgentQueries.nearest. It has the same arguments, answers and errors. */
        public function nearest(agent:Agent, radius:Number = Infinity, filter:AgentFilter = null):Agent
        {
            return idle.findNear(agent, radius, 1, filter).endWithFirst();
        }

        /** See AgentQueries.nearestFew. It has the same arguments, answers and errors. */
        public function nearestFew(agent:Agent, count:int, radius:Number = Infinity, filter:AgentFilter = null, out:Vector.<Agent> = null):Vector.<Agent>
        {
            requireNotNegative("count", count);
            return idle.findNear(agent, radius, count, filter).endWithList(out);
        }

        /** See AgentQueries.nearPoint. It has the same arguments, answers and errors. */
        public function nearPoint(point:Vector3D, radius:Number, filter:AgentFilter = null, out:Vector.<Agent> = null):Vector.<Agent>
        {
            return idle.findNearPoint(point, radius, Collector.ALL, filter).endWithList(out);
        }

        /** See AgentQueries.countNearPoint. It has the same arguments, answers and errors. */
        public function countNearPoint(point:Vector3D, radius:Number, filter:AgentFilter = null):int
        {
            requirePoint(point);
            return idle.count(null, point.x, point.y, point.z, radius, filter);
        }

        /** See AgentQueries.nearestToPoint. It has the same arguments, answers and errors. */
        public function nearestToPoint(point:Vector3D, radius:Number = Infinity, filter:AgentFilter = null):Agent
        {
            return idle.findNearPoint(point, radius, 1, filter).endWithFirst();
        }

        /** See AgentQueries.inCone. It has the same arguments, answers and errors. */
        public function inCone(agent:Agent, radius:Number, degrees:Number, filter:AgentFilter = null, out:Vector.<Agent> = null):Vector.<Agent>
        {
            requireNotNegative("degrees", degrees);
            return idle.findNear(agent, radius, Collector.ALL, filter, degrees).endWithList(out);
        }

        // These questions, or the nested ones while a filter's accepts is being called.
        private function get idle():AgentPlaces
        {
            return _found.isAsking ? (_nested ||= new AgentPlaces(_seen)).idle : this;
        }

        private function findNear(agent:Agent, radius:Number, wanted:int, filter:AgentFilter, degrees:Number = 360):Collector
        {
            var at:Placement = _seen.placeOf(agent);
            return find(agent, at.x, at.y, at.z, radius, wanted, filter, degrees);
        }

        private function findNearPoint(point:Vector3D, radius:Number, wanted:int, filter:AgentFilter):Collector
        {
            requirePoint(point);
            return find(null, point.x, point.y, point.z, radius, wanted, filter, 360);
        }

        // Finds the agents near a place, without the one that asks, which may be null. From 360 degrees on there is no cone in front of it. Returns what
        // has the answer.
        private function find(asker:Agent, x:Number, y:Number, z:Number, radius:Number, wanted:int, filter:AgentFilter, degrees:Number):Collector
        {
            requireNotNegative("radius", radius);
            _found.begin(wanted, radius * radius, asker, filter);
            var cone:Cone = degrees < 360 ? _cone.setTo(asker.worldPlacement(), degrees / 2) : null;
            _near.find(_seen.treeOfPlaces(), x, y, z, _found, cone);
            return _found;
        }

        private function count(asker:Agent, x:Number, y:Number, z:Number, radius:Number, filter:AgentFilter):int
        {
            requireNotNegative("radius", radius);
            _found.begin(Collector.ALL, radius * radius, asker, filter);
            return _near.count(_seen.treeOfPlaces(), x, y, z, _found);
        }
    }
}
