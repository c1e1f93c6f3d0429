package starlogo.queries
{
    import flash.geom.Vector3D;
    import starlogo.agents.Agent;
    import starlogo.bounding.BoundingStructure;
    import starlogo.engine;
    import starlogo.search.AgentTable;
    import starlogo.search.Body;
    import starlogo.search.RowList;
    import starlogo.terrain.WorldBounds;

    use namespace engine;

    /**
     * Answers which agents touch an agent or a structure.
     *
     * @private
     */
    public final class TouchQuestions
    {
        private var _seen:SeenAgents;
        private var _search:WaySearch = new WaySearch();
        private var _found:Collector;
        private var _place:Vector3D = new Vector3D();
        private var _moved:Body = new Body();

        /** @param seen the agents that questions are about */
        public function TouchQuestions(seen:SeenAgents)
        {
            _seen = seen;
            _found = new Collector(seen);
        }

        /** Lists the agents that touch an agent or a structure. See AgentQueries.touching and AgentQueries.overlapping. */
        public function list(agent:Agent, structure:BoundingStructure, filter:AgentFilter, out:Vector.<Agent>):Vector.<Agent>
        {
            find(agent, structure, null, Collector.ALL, filter);
            return _found.list(out);
        }

        /** See AgentQueries.touchesAny. The search ends at the first row that counts. */
        public function touchesAny(agent:Agent, filter:AgentFilter, place:Vector3D = null):Boolean
        {
            find(agent, null, place, 1, filter);
            return _found.end() > 0;
        }

        /** See AgentQueries.overlapsAgent. */
        public function overlapsAgent(agent:Agent, x:Number, y:Number, z:Number, filter:AgentFilter):Boolean
        {
            _seen.placeOf(agent);
            _place.setTo(x, y, z);
            return touchesAny(agent, filter, _place);
        }

        /** See AgentQueries.touchesEdge. */
        public function touchesEdge(agent:Agent, bounds:WorldBounds):Boolean
        {
            if (bounds == null)
            {
                throw new ArgumentError("bounds must not be null");
            }
            var body:Body = _seen.bodyOf(agent, _seen.asker);
            return body.shape != null && _seen.pairs.areTouching(body, _seen.bodyOf(bounds.agent, _seen.other));
        }

        // Finds the rows that touch an agent or a structure, or would touch the agent at a place if there is one.
        private function find(agent:Agent, structure:BoundingStructure, place:Vector3D, wanted:int, filter:AgentFilter):void
        {
            var body:Body = _seen.bodyOfEither(agent, structure);
            _found.begin(wanted, Infinity, agent, filter);
            if (body.shape != null)
            {
                if (place != null)
                {
                    _moved.readPart(body, place, 0);
                    body = _moved;
                }
                collectNear(body);
            }
        }

        // Collects the rows that count and touch a body. Each gets its distance from the body's place.
        private function collectNear(body:Body):void
        {
            var table:AgentTable = _seen.table;
            var found:Collector = _found;
            _seen.beginWay(_search, body);
            // if one row is wanted, it may be any that touches
            for (var other:int = _search.next(); other >= 0 && !(found.keepsFirst && found.count > 0); other = _search.next())
            {
                if (table.shapes[other] != null && found.admits(other) && _seen.pairs.areTouching(body, table.bodyOf(other)))
                {
                    var toX:Number = table.now.x[other] - body.placement.x;
                    var toY:Number = table.now.y[other] - body.placement.y;
                    var toZ:Number = table.now.z[other] - body.placement.z;
                    // the ground has no place, so it comes last
                    found.add(other, other == RowList.GROUND ? Infinity : toX * toX + toY * toY + toZ * toZ);
                }
            }
        }
    }
}
