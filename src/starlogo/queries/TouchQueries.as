package starlogo.queries
{
    import flash.geom.Vector3D;
    import starlogo.agents.Agent;
    import starlogo.bounding.BoundingStructure;
    import starlogo.data.requireGiven;
    import starlogo.engine;
    import starlogo.geometry.requireInWorld;
    import starlogo.queries.trees.Collector;
    import starlogo.queries.trees.SweptBoxSearch;
    import starlogo.search.Body;
    import starlogo.search.StructureBody;
    import starlogo.search.table.AgentTable;
    import starlogo.search.table.ListedAgents;
    import starlogo.terrain.WorldBounds;

    use namespace engine;

    /**
     * Answers which agents touch an agent or a structure. AgentQueries says what each question means.
     *
     * @private
     */
    public final class TouchQueries
    {
        private var _seen:SeenAgents;
        private var _search:SweptBoxSearch = new SweptBoxSearch();

        // A body that is not an agent's: one at another place, or the edges of the world; that of a structure; and this place.
        private var _body:Body = new Body();
        private var _structureBody:StructureBody = new StructureBody();
        private var _place:Vector3D = new Vector3D();

        /** @param seen the agents that the questions are about */
        public function TouchQueries(seen:SeenAgents)
        {
            _seen = seen;
        }

        /** See AgentQueries.touching. */
        public function touching(agent:Agent, filter:AgentFilter, out:Vector.<Agent>):Vector.<Agent>
        {
            return find(agent, _seen.bodyOf(agent), Collector.ALL, filter).endWithList(out);
        }

        /** See AgentQueries.touchesAny. */
        public function touchesAny(agent:Agent, filter:AgentFilter):Boolean
        {
            return find(agent, _seen.bodyOf(agent), 1, filter).end() > 0;
        }

        /** See AgentQueries.touchesEdge. */
        public function touchesEdge(agent:Agent, bounds:WorldBounds):Boolean
        {
            requireGiven("bounds", bounds);
            var body:Body = _seen.bodyOf(agent);
            return body.shape != null && _seen.narrowPhase.areTouching(body, _seen.bodyOf(bounds.agent, _body));
        }

        /** See AgentQueries.wouldTouchAt. */
        public function wouldTouchAt(agent:Agent, x:Number, y:Number, z:Number, filter:AgentFilter):Boolean
        {
            _seen.requirePlaced(agent);
            requireInWorld("a place", x, y, z, agent);
            _place.setTo(x, y, z);
            _body.copyFrom(_seen.bodyOf(agent));
            _body.moveTo(_place);
            return find(agent, _body, 1, filter).end() > 0;
        }

        /** See AgentQueries.overlapping. */
        public function overlapping(structure:BoundingStructure, filter:AgentFilter, out:Vector.<Agent>):Vector.<Agent>
        {
            return find(null, _structureBody.read(structure), Collector.ALL, filter).endWithList(out);
        }

        // Finds the agents that touch a body, sorted by the distances of their places from the body's place. If one is wanted, it may be any that
        // touches. The agent that asks is left out; it may be null. While the body's model is loading it touches nothing.
        private function find(asker:Agent, body:Body, wanted:int, filter:AgentFilter):Collector
        {
            var table:AgentTable = _seen.table;
            var collector:Collector = _seen.beginSearch(wanted, Infinity, asker, filter);
            if (body.shape == null)
            {
                return collector;
            }
            _search.beginAround(_seen.treeOfExtents(), body);
            for (var row:int = collector.nextCandidate(_search); row >= 0; row = collector.nextCandidate(_search))
            {
                if (_seen.narrowPhase.areTouching(body, table.bodyOf(row)))
                {
                    var toX:Number = table.places.x[row] - body.placement.x;
                    var toY:Number = table.places.y[row] - body.placement.y;
                    var toZ:Number = table.places.z[row] - body.placement.z;
                    // the ground has no place, so it comes last
                    collector.add(row, row == ListedAgents.GROUND_ROW ? Infinity : toX * toX + toY * toY + toZ * toZ);
                    if (collector.hasEnoughOfAny)
                    {
                        break;
                    }
                }
            }
            return collector;
        }
    }
}
