package starlogo.queries
{
    import flash.geom.Vector3D;
    import starlogo.agents.Agent;
    import starlogo.engine;
    import starlogo.geometry.Placement;

    use namespace engine;

    /**
     * Answers which agents have their places near a point. AgentQueries says what each question means.
     *
     * @private
     */
    public final class PlaceQueries
    {
        private var _seen:SeenAgents;
        private var _found:Collector;
        private var _near:NearSearch = new NearSearch();
        private var _count:CountSearch = new CountSearch();
        private var _cone:Cone = new Cone();

        // For the questions of an accepts that these call.
        private var _nested:PlaceQueries = null;

        /** @param seen the agents that the questions are about */
        public function PlaceQueries(seen:SeenAgents)
        {
            _seen = seen;
            _found = new Collector(seen);
        }

        /** These questions; others while these call a filter's <code>accepts</code>, which may ask questions itself. */
        public function get idle():PlaceQueries
        {
            if (!_found.isAsking)
            {
                return this;
            }
            _nested ||= new PlaceQueries(_seen);
            return _nested.idle;
        }

        public function near(agent:Agent, radius:Number, filter:AgentFilter, out:Vector.<Agent>):Vector.<Agent>
        {
            return findNear(agent, radius, Collector.ALL, filter).list(out);
        }

        public function countNear(agent:Agent, radius:Number, filter:AgentFilter):int
        {
            var at:Placement = _seen.placeOf(agent);
            return count(agent, at.x, at.y, at.z, radius, filter);
        }

        public function nearest(agent:Agent, radius:Number, filter:AgentFilter):Agent
        {
            return findNear(agent, radius, 1, filter).firstAgent();
        }

        public function nearestFew(agent:Agent, count:int, radius:Number, filter:AgentFilter, out:Vector.<Agent>):Vector.<Agent>
        {
            requireNotNegative("count", count);
            return findNear(agent, radius, count, filter).list(out);
        }

        public function inCone(agent:Agent, radius:Number, degrees:Number, filter:AgentFilter, out:Vector.<Agent>):Vector.<Agent>
        {
            requireNotNegative("degrees", degrees);
            return findNear(agent, radius, Collector.ALL, filter, degrees).list(out);
        }

        public function nearPoint(point:Vector3D, radius:Number, filter:AgentFilter, out:Vector.<Agent>):Vector.<Agent>
        {
            return findNearPoint(point, radius, Collector.ALL, filter).list(out);
        }

        public function countNearPoint(point:Vector3D, radius:Number, filter:AgentFilter):int
        {
            requirePoint(point);
            return count(null, point.x, point.y, point.z, radius, filter);
        }

        public function nearestToPoint(point:Vector3D, radius:Number, filter:AgentFilter):Agent
        {
            return findNearPoint(point, radius, 1, filter).firstAgent();
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
            _near.find(_seen.findPlaces(), x, y, z, _found, cone);
            return _found;
        }

        private function count(asker:Agent, x:Number, y:Number, z:Number, radius:Number, filter:AgentFilter):int
        {
            if (filter != null && filter.accepts != null)
            {
                return find(asker, x, y, z, radius, Collector.ALL, filter, 360).end();
            }
            requireNotNegative("radius", radius);
            _found.filter.begin(asker, filter);
            return _count.count(_seen.findPlaces(), x, y, z, radius * radius, _found.filter);
        }
    }
}
