package starlogo.queries
{
    import flash.geom.Vector3D;
    import starlogo.agents.Agent;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Sphere;
    import starlogo.collision.Collider;
    import starlogo.convex.ClosestPoints;
    import starlogo.data.requireGiven;
    import starlogo.engine;
    import starlogo.geometry.copyVector;
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
     * Answers which agents touch an agent or a structure, and how far two of them are apart, as a collider sees them. AgentQueries says what each
     * question means.
     *
     * <p>A distance is 0 if the collider's own test says that the two touch, and greater otherwise. Shapes are wider by the margin for the rounding of
     * places (Tolerances.PLACES), as they are in tests for touching.</p>
     *
     * @private
     */
    public final class TouchQueries
    {
        private var _seen:SeenAgents;
        private var _search:SweptBoxSearch = new SweptBoxSearch();
        private var _closest:ClosestPoints = new ClosestPoints();

        // A second body: another agent's, that of the agent at another place, or that of the edges of the world.
        private var _body:Body = new Body();

        // The body of a structure or a point, and a point or a place as a sphere without radius.
        private var _structureBody:StructureBody = new StructureBody();
        private var _point:Sphere = new Sphere(new Vector3D(), 0);

        /** @param seen the agents that the questions are about */
        public function TouchQueries(seen:SeenAgents)
        {
            _seen = seen;
        }

        /** See AgentQueries.touching. */
        public function touching(agent:Agent, filter:AgentFilter, out:Vector.<Agent>):Vector.<Agent>
        {
            return find(agent, _seen.currentBodyOf(agent), Collector.ALL, filter).endWithList(out);
        }

        /** See AgentQueries.touchesAny. */
        public function touchesAny(agent:Agent, filter:AgentFilter):Boolean
        {
            return find(agent, _seen.currentBodyOf(agent), 1, filter).end() > 0;
        }

        /** See AgentQueries.touchesEdge. */
        public function touchesEdge(agent:Agent, bounds:WorldBounds):Boolean
        {
            requireGiven("bounds", bounds);
            var body:Body = _seen.currentBodyOf(agent);
            return body.shape != null && _seen.narrowPhase.areTouching(body, _seen.currentBodyOf(bounds.agent, _body));
        }

        /** See AgentQueries.wouldTouchAt. */
        public function wouldTouchAt(agent:Agent, x:Number, y:Number, z:Number, filter:AgentFilter):Boolean
        {
            _seen.requirePlaced(agent);
            requireInWorld("a place", x, y, z, agent);
            _point.center.setTo(x, y, z);
            _body.copyFrom(_seen.currentBodyOf(agent));
            _body.moveTo(_point.center);
            return find(agent, _body, 1, filter).end() > 0;
        }

        /** See AgentQueries.overlapping. */
        public function overlapping(structure:BoundingStructure, filter:AgentFilter, out:Vector.<Agent>):Vector.<Agent>
        {
            return find(null, _structureBody.setTo(structure), Collector.ALL, filter).endWithList(out);
        }

        /**
         * The distance between two agents. See AgentQueries.distance.
         *
         * @param pointA receives the first agent's nearest point; or null
         * @param pointB receives the second agent's nearest point; or null
         */
        public function distance(a:Agent, b:Agent, pointA:Vector3D, pointB:Vector3D):Number
        {
            Collider.requireTwo(a, b);
            // a handler may have changed the ground
            _seen.table.environment.refresh();
            if (a.isEnvironment && b.isEnvironment)
            {
                throw new ArgumentError("the ground and the edges of the world have no distance from each other");
            }
            var rowB:int = _seen.rowOf(b);
            if (rowB >= 0 && _seen.table.shapes[rowB] == null)
            {
                return Infinity;
            }
            return measure(_seen.currentBodyOf(a), rowB < 0 ? _seen.currentBodyOf(b, _body) : _seen.table.bodyOf(rowB), pointA, pointB);
        }

        /** The distance between an agent and a point. See AgentQueries.distanceToPoint. */
        public function distanceToPoint(agent:Agent, point:Vector3D, out:Vector3D):Number
        {
            requireGiven("point", point);
            requireInWorld("a point", point.x, point.y, point.z);
            _point.center.setTo(point.x, point.y, point.z);
            var distance:Number = measure(_seen.currentBodyOf(agent), _structureBody.setTo(_point), out, null);
            if (distance == 0)
            {
                // without the rounding of that point, which stands in the game's point if that is out too
                copyTo(out, _point.center);
            }
            return distance;
        }

        private function measure(a:Body, b:Body, pointA:Vector3D, pointB:Vector3D):Number
        {
            if (a.shape == null || b.shape == null)
            {
                return Infinity;
            }
            _seen.narrowPhase.findClosest(a, b, pointA != null || pointB != null, _closest);
            if (_closest.distance == Infinity)
            {
                // the edges of a world without edges have no points
                return Infinity;
            }
            copyTo(pointA, _closest.a);
            copyTo(pointB, _closest.b);
            return _closest.distance;
        }

        private static function copyTo(out:Vector3D, point:Vector3D):void
        {
            if (out != null)
            {
                copyVector(point, out);
            }
        }

        // Finds the agents that touch a body, sorted by the distances of their places from the body's place. If one is wanted, it may be any that
        // touches. The agent that asks is left out; it may be null. While the body's model is loading it touches nothing.
        private function find(asker:Agent, body:Body, maxCount:int, filter:AgentFilter):Collector
        {
            var table:AgentTable = _seen.table;
            var collector:Collector = _seen.beginCollecting(maxCount, Infinity, asker, filter);
            if (body.shape == null)
            {
                return collector;
            }
            _search.setAround(_seen.treeOfExtents(), body);
            for (var row:int = _search.next(collector); row >= 0; row = _search.next(collector))
            {
                if (_seen.narrowPhase.areTouching(body, table.bodyOf(row)))
                {
                    var toX:Number = table.places.x[row] - body.placement.x;
                    var toY:Number = table.places.y[row] - body.placement.y;
                    var toZ:Number = table.places.z[row] - body.placement.z;
                    // the ground has no place, so it comes last
                    collector.add(row, row == ListedAgents.GROUND_ROW ? Infinity : toX * toX + toY * toY + toZ * toZ);
                    if (collector.hasEnough)
                    {
                        break;
                    }
                }
            }
            return collector;
        }
    }
}
