package starlogo.queries
{
    import flash.geom.Vector3D;
    import starlogo.agents.Agent;
    import starlogo.data.requireGiven;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.geometry.requireInWorld;
    import starlogo.intersection.isAfter;
    import starlogo.intersection.ray.Ray;
    import starlogo.intersection.ray.RayEntry;
    import starlogo.queries.rays.Hits;
    import starlogo.queries.rays.RowRays;
    import starlogo.queries.trees.Collector;
    import starlogo.queries.trees.SweptBoxSearch;
    import starlogo.search.Body;

    use namespace engine;

    /**
     * Answers what a ray meets: the questions of AgentQueries about rays, for games that load no others. Their rules stand there.
     */
    public final class AgentRays
    {
        private var _seen:SeenAgents;
        private var _found:Collector;
        private var _search:SweptBoxSearch = new SweptBoxSearch();
        private var _rowRays:RowRays;
        private var _ray:Ray = new Ray();
        private var _entry:RayEntry = new RayEntry();
        private var _hits:Hits;

        // For the line between two agents.
        private var _middleA:Vector3D = new Vector3D();
        private var _middleB:Vector3D = new Vector3D();

        // Answers what an accepts asks while these questions call it.
        private var _nested:AgentRays = null;

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
            _found = new Collector(seen);
            _rowRays = new RowRays(seen);
            _hits = new Hits(seen, _found, RayHit);
        }

        /** See AgentQueries.cast. It has the same arguments, answers and errors. */
        public function cast(origin:Vector3D, direction:Vector3D, maxDistance:Number = Infinity, filter:AgentFilter = null, hit:RayHit = null):RayHit
        {
            return idle.castFirst(origin, direction, maxDistance, filter, hit);
        }

        /** See AgentQueries.castAll. It has the same arguments, answers and errors. */
        public function castAll(origin:Vector3D, direction:Vector3D, maxDistance:Number = Infinity, filter:AgentFilter = null,
                out:Vector.<RayHit> = null, allSurfaces:Boolean = false):Vector.<RayHit>
        {
            return idle.castThrough(origin, direction, maxDistance, filter, out || new Vector.<RayHit>(), allSurfaces);
        }

        /** See AgentQueries.canSee. It has the same arguments, answers and errors. */
        public function canSee(a:Agent, b:Agent, filter:AgentFilter = null):Boolean
        {
            return idle.isWayFree(a, b, filter);
        }

        // These questions, or the nested ones while a filter's accepts is being called.
        private function get idle():AgentRays
        {
            return _found.isAsking ? (_nested ||= new AgentRays(_seen)).idle : this;
        }

        private function castFirst(origin:Vector3D, direction:Vector3D, maxDistance:Number, filter:AgentFilter, hit:RayHit):RayHit
        {
            begin(1, requireOrigin(origin), direction, maxDistance, filter);
            collect();
            return _hits.endWithFirsts() == 0 ? null : write(0, hit || new RayHit());
        }

        private function castThrough(origin:Vector3D, direction:Vector3D, maxDistance:Number, filter:AgentFilter, out:Vector.<RayHit>,
                allSurfaces:Boolean):Vector.<RayHit>
        {
            begin(Collector.ALL, requireOrigin(origin), direction, maxDistance, filter);
            if (allSurfaces)
            {
                collectSurfaces();
                _hits.resize(out, _hits.endWithAll());
            }
            else
            {
                collect();
                _hits.resize(out, _hits.endWithFirsts());
            }
            for (var i:int = 0; i < out.length; i++)
            {
                write(i, out[i]);
            }
            return out;
        }

        private function isWayFree(a:Agent, b:Agent, filter:AgentFilter):Boolean
        {
            findMiddle(a, _middleA);
            findMiddle(b, _middleB);
            // the ray always starts at the same place of the two, because rounding may let a ray that grazes something pass in one direction only
            var isSwapped:Boolean = isAfter(_middleA, _middleB);
            var from:Vector3D = isSwapped ? _middleB : _middleA;
            var towards:Vector3D = isSwapped ? _middleA : _middleB;
            towards.decrementBy(from);
            var distance:Number = Math.sqrt(towards.x * towards.x + towards.y * towards.y + towards.z * towards.z);
            if (distance == 0)
            {
                // any direction will do
                towards.z = 1;
            }
            var rowA:int = _seen.rowOf(a);
            var rowB:int = _seen.rowOf(b);
            begin(1, from, towards, distance, filter);
            for (var row:int = _found.nextOf(_search); row >= 0 && !_found.canEnd; row = _found.nextOf(_search))
            {
                if (row != rowA && row != rowB && _rowRays.findHit(row, _ray, _entry))
                {
                    _found.add(row, _entry.distance);
                }
            }
            return _found.end() == 0;
        }

        // Finds the middle of an agent's extents as it is now. While the model is loading it is the agent's place.
        private function findMiddle(agent:Agent, out:Vector3D):void
        {
            var at:Placement = _seen.placeOf(agent);
            var body:Body = _seen.bodyOf(agent);
            if (body.shape == null)
            {
                out.setTo(at.x, at.y, at.z);
            }
            else
            {
                out.setTo(body.x, body.y, body.z);
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

        private function begin(wanted:int, origin:Vector3D, direction:Vector3D, maxDistance:Number, filter:AgentFilter):void
        {
            var ray:Ray = _ray;
            ray.aim(origin, direction);
            requireNotNegative("maxDistance", maxDistance);
            ray.to = maxDistance;
            _found.begin(wanted, maxDistance, null, filter);
            _hits.begin();
            _search.begin(_seen.treeOfExtents(), ray.x, ray.y, ray.z, 0, 0, 0);
            _search.moveAlong(ray.directionX, ray.directionY, ray.directionZ, maxDistance);
        }

        // Finds the rows that the ray meets, and keeps how it meets them.
        private function collect():void
        {
            var ray:Ray = _ray;
            for (var row:int = _found.nextOf(_search); row >= 0; row = _found.nextOf(_search))
            {
                if (_rowRays.findHit(row, ray, _entry))
                {
                    _found.add(row, _entry.distance);
                    _hits.addEntry(row, ray, _entry);
                    ray.to = _found.limit;
                }
            }
        }

        // Finds the rows that the ray meets, and keeps all surfaces that it crosses.
        private function collectSurfaces():void
        {
            for (var row:int = _found.nextOf(_search); row >= 0; row = _found.nextOf(_search))
            {
                if (_rowRays.findSurfaces(row, _ray, _hits))
                {
                    _found.add(row, _hits.firstKeyOf(row));
                }
            }
        }

        // Writes how the ray meets a row of the answer.
        private function write(index:int, hit:RayHit):RayHit
        {
            _hits.write(index, hit);
            hit.distance = _hits.keyOf(index);
            return hit;
        }
    }
}
