package starlogo.queries
{
    import flash.geom.Vector3D;
    import starlogo.agents.Agent;
    import starlogo.data.requireGiven;
    import starlogo.engine;
    import starlogo.geometry.compareVectors;
    import starlogo.geometry.requireInWorld;
    import starlogo.intersection.ray.Ray;
    import starlogo.intersection.ray.RayCrossing;
    import starlogo.queries.rays.RayHits;
    import starlogo.queries.rays.RowRayTest;
    import starlogo.queries.rays.SurfaceCrossings;
    import starlogo.queries.trees.Collector;
    import starlogo.queries.trees.SweptBoxSearch;
    import starlogo.search.Body;

    use namespace engine;

    /**
     * Answers what a ray meets, for games that load no other questions. The rules for all questions are at AgentQueries.
     */
    public final class AgentRays
    {
        private var _seen:SeenAgents;
        private var _search:SweptBoxSearch = new SweptBoxSearch();
        private var _rowRays:RowRayTest;
        private var _ray:Ray = new Ray();

        // Where the ray enters a row, or the surfaces of the row that it crosses.
        private var _entry:RayCrossing = new RayCrossing();
        private var _surfaces:SurfaceCrossings = new SurfaceCrossings();

        // How the ray of a question meets rows.
        private var _rayHitsPool:NestedPool;

        // For the line between two agents.
        private var _middleA:Vector3D = new Vector3D();
        private var _middleB:Vector3D = new Vector3D();

        /**
         * Asks about the agents of a SeenAgents. Others may ask about the same.
         *
         * @param seen the agents that the questions see
         * @throws ArgumentError if it is null
         */
        public function AgentRays(seen:SeenAgents)
        {
            requireGiven("seen", seen);
            _seen = seen;
            _rowRays = new RowRayTest(seen);
            _rayHitsPool = new NestedPool(seen, RayHits);
        }

        /**
         * The first agent that a ray meets. If it meets several at the same distance, it is the first of them in the list. A ray is a line
         * without thickness. An agent's surface is a part of the agent.
         *
         * <p>If the ray's origin is inside an agent, the distance is 0. "Inside" means inside its structure, inside a node of its tree at the
         * depth limit, or, in exact mode, inside its closed surface. The ray meets triangles from either side. No ray slips through a common
         * edge or corner of triangles.</p>
         *
         * <p>If a ray meets an agent in exact mode, it meets the agent in every other system too, at the same distance or nearer. Only the
         * BinCollider is an exception, and models without triangles, which a ray meets at their leaves. If a ray meets an agent at one depth,
         * it meets the agent at every smaller depth too, at the same distance or nearer.</p>
         *
         * <p>In exact mode a model's triangles have to be prepared for rays. This happens when the first ray meets the extents of an agent with
         * the model, or when the model is added if GreatLand.prepareExact is set. Times are in docs/measurements.md.</p>
         *
         * @param origin where the ray begins, in the world
         * @param direction of any length but 0
         * @param maxDistance how far the ray goes, in patches. An agent at exactly this distance is met
         * @param filter the agents that count; null for all. <code>accepts</code> is called for the agents that the ray meets, beginning with
         *     the nearest, until one is accepted
         * @param hit receives the answer; null for a new RayHit
         * @return hit, or the new RayHit. It is null if the ray meets no agent, and hit is then unchanged
         * @throws ArgumentError if origin or direction is null, or if the direction is 0 or not finite
         * @throws RangeError if the origin is not in the world, or if maxDistance is negative or not a number
         */
        public function cast(origin:Vector3D, direction:Vector3D, maxDistance:Number = Infinity, filter:AgentFilter = null, hit:RayHit = null):RayHit
        {
            return findHits(begin(1, requireOrigin(origin), direction, maxDistance, filter), false).writeFirst(hit);
        }

        /**
         * Lists every agent that a ray meets, with the point where the ray first meets it. The rules of <code>cast()</code> apply.
         *
         * <p>With <code>allSurfaces</code> an agent has a hit for each surface that the ray crosses. The first of them is the agent's hit
         * without <code>allSurfaces</code>. All hits are sorted by distance. At the same distance they are in the order of the list, and those
         * of one agent along the ray. A ray enters a structure and leaves it. If the nodes of a tree are the surface, the ray crosses it where
         * it enters the first of nodes that overlap, and where it leaves the last. If triangles decide, each triangle is a surface. Triangles
         * that the ray meets at the same place, up to rounding, are one surface if the ray comes to them from the same side. So a common edge
         * or corner is one hit. An edge at which the ray only grazes a closed model is two: there it goes in and out. Triangles that the ray
         * runs along are one hit, where it begins to, or none if it meets another triangle there. A ray that begins inside of an agent has a
         * hit at distance 0, and one where it comes out.</p>
         *
         * @param origin where the ray begins, in the world
         * @param direction of any length but 0
         * @param maxDistance how far the ray goes, in patches
         * @param filter the agents that count; null for all
         * @param out receives the list; null for a new list. The hits in it are overwritten, so none may be in it twice. Surplus hits are removed
         *     and used again later. Copy a hit that you want to keep
         * @param allSurfaces whether an agent has a hit for each surface that the ray crosses, not only for its first
         * @return out, or the new list
         * @throws ArgumentError as cast does
         * @throws RangeError as cast does
         */
        public function castAll(origin:Vector3D, direction:Vector3D, maxDistance:Number = Infinity, filter:AgentFilter = null,
                out:Vector.<RayHit> = null, allSurfaces:Boolean = false):Vector.<RayHit>
        {
            var collector:Collector = begin(Collector.ALL, requireOrigin(origin), direction, maxDistance, filter);
            return findHits(collector, allSurfaces).writeAll(out || new Vector.<RayHit>());
        }

        /**
         * Whether no agent is between two agents. It tests the line between the middles of their extents. Both agents are seen where they are
         * now, and need not be in the list. While an agent's model is loading, its place is used as its middle. An
         * agent sees itself. If one of the middles is inside a third agent, that agent is between the two.
         *
         * @param a one of them
         * @param b the other
         * @param filter the agents that can be in the way; null for all
         * @throws ArgumentError if one is null, or if its model is unknown or lacks data that the collision system needs
         */
        public function canSee(a:Agent, b:Agent, filter:AgentFilter = null):Boolean
        {
            findMiddle(a, _middleA);
            findMiddle(b, _middleB);
            if (a === b)
            {
                return true;
            }
            // the ray always starts at the same place of the two, because rounding may let a ray that grazes something pass in one direction only
            var isReversed:Boolean = compareVectors(_middleA, _middleB) > 0;
            var from:Vector3D = isReversed ? _middleB : _middleA;
            var towards:Vector3D = isReversed ? _middleA : _middleB;
            towards.decrementBy(from);
            var distance:Number = towards.length;
            if (distance == 0)
            {
                // any direction will do
                towards.z = 1;
            }
            var rowA:int = _seen.rowOf(a);
            var rowB:int = _seen.rowOf(b);
            var collector:Collector = begin(1, from, towards, distance, filter);
            for (var row:int = _search.next(collector); row >= 0; row = _search.next(collector))
            {
                if (row != rowA && row != rowB && _rowRays.findRayEntry(row, _ray, _entry))
                {
                    collector.add(row, _entry.distance);
                    if (collector.hasEnough)
                    {
                        break;
                    }
                }
            }
            return collector.end() == 0;
        }

        // Finds the middle of an agent's extents as it is now. While the model is loading it is the agent's place.
        private function findMiddle(agent:Agent, out:Vector3D):void
        {
            _seen.requirePlaced(agent);
            var body:Body = _seen.currentBodyOf(agent);
            if (body.shape == null)
            {
                out.setTo(agent.x, agent.y, agent.z);
            }
            else
            {
                out.setTo(body.middleX, body.middleY, body.middleZ);
            }
        }

        // Returns a ray's origin, which must be in the world. The middles that canSee uses may be a little outside, so it does not call this.
        private static function requireOrigin(origin:Vector3D):Vector3D
        {
            if (origin != null)
            {
                requireInWorld("a ray's origin", origin.x, origin.y, origin.z);
            }
            return origin;
        }

        private function begin(maxCount:int, origin:Vector3D, direction:Vector3D, maxDistance:Number, filter:AgentFilter):Collector
        {
            _ray.aim(origin, direction);
            requireNotNegative("maxDistance", maxDistance);
            _ray.to = maxDistance;
            var collector:Collector = _seen.beginCollecting(maxCount, maxDistance, null, filter);
            _search.setTo(_seen.treeOfExtents(), _ray.origin);
            _search.moveAlong(_ray.direction);
            return collector;
        }

        // Finds the hits of the ray: with the first surface of each row that it crosses, or with all of them.
        private function findHits(collector:Collector, allSurfaces:Boolean):RayHits
        {
            var hits:RayHits = RayHits(_rayHitsPool.current);
            hits.begin(collector);
            for (var row:int = _search.next(collector); row >= 0; row = _search.next(collector))
            {
                if (allSurfaces)
                {
                    _rowRays.findSurfaces(row, _ray, _surfaces);
                    hits.addSurfaces(row, _ray, _surfaces);
                }
                else if (_rowRays.findRayEntry(row, _ray, _entry))
                {
                    hits.add(row, _ray, _entry);
                    _ray.to = collector.limit;
                }
            }
            hits.end();
            return hits;
        }
    }
}
