package starlogo.queries
{
    import flash.geom.Vector3D;
    import starlogo.agents.Agent;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.geometry.requireInWorld;
    import starlogo.intersection.ray.Ray;
    import starlogo.search.Body;

    use namespace engine;

    /**
     * Answers which agents a ray meets.
     *
     * @private
     */
    public final class RayQuestions
    {
        private var _seen:SeenAgents;
        private var _search:WaySearch = new WaySearch();
        private var _rays:RowRays = new RowRays();
        private var _ray:Ray = _rays.ray;

        private var _found:Collector;
        private var _pool:HitPool = new HitPool(RayHit);

        // By row: the number of its hit. By hit: its distance and its normal, and its triangle. There is no RayHit for it before the answer is
        // known.
        private var _hitOf:Vector.<int> = new Vector.<int>();
        private var _hits:Vector.<Number> = new Vector.<Number>();
        private var _triangles:Vector.<int> = new Vector.<int>();
        private var _hitCount:int = 0;

        private var _middleA:Vector3D = new Vector3D();
        private var _middleB:Vector3D = new Vector3D();

        /** @param seen the agents that questions are about */
        public function RayQuestions(seen:SeenAgents)
        {
            _seen = seen;
            _found = new Collector(seen);
        }

        /** See AgentQueries.cast. */
        public function cast(origin:Vector3D, direction:Vector3D, maxDistance:Number, filter:AgentFilter, hit:RayHit):RayHit
        {
            begin(1, checked(origin), direction, maxDistance, filter);
            collect();
            var row:int = _found.first();
            return row < 0 ? null : write(row, hit || new RayHit());
        }

        /** See AgentQueries.castAll. */
        public function castAll(origin:Vector3D, direction:Vector3D, maxDistance:Number, filter:AgentFilter, out:Vector.<RayHit>):Vector.<RayHit>
        {
            begin(Collector.ALL, checked(origin), direction, maxDistance, filter);
            collect();
            var hits:Vector.<RayHit> = out || new Vector.<RayHit>();
            var rows:Vector.<int> = _found.sorted();
            _pool.fit(hits, _found.end());
            for (var i:int = 0; i < hits.length; i++)
            {
                write(rows[i], hits[i]);
            }
            return hits;
        }

        /** See AgentQueries.canSee. */
        public function canSee(a:Agent, b:Agent, filter:AgentFilter):Boolean
        {
            findMiddle(a, _middleA);
            findMiddle(b, _middleB);
            // the ray always starts at the same agent of the two, because rounding may let a ray that grazes something pass in one direction only
            var isTurned:Boolean = a.number > b.number;
            var from:Vector3D = isTurned ? _middleB : _middleA;
            var towards:Vector3D = isTurned ? _middleA : _middleB;
            towards.decrementBy(from);
            var distance:Number = Math.sqrt(towards.x * towards.x + towards.y * towards.y + towards.z * towards.z);
            if (distance == 0)
            {
                // any direction will do
                towards.z = 1;
            }
            begin(1, from, towards, distance, filter);
            _found.skipped = _seen.rowOf(a);
            _found.skippedToo = _seen.rowOf(b);
            // any row will do, unless accepts decides
            for (var row:int = next(); row >= 0; row = _found.asks ? next() : -1)
            {
                _found.add(row, _ray.from);
            }
            return _found.end() == 0;
        }

        // Finds the middle of an agent's extents as it is now. While the model is loading it is the agent's place.
        private function findMiddle(agent:Agent, out:Vector3D):void
        {
            var at:Placement = _seen.placeOf(agent);
            var body:Body = _seen.bodyOf(agent, _seen.asker);
            if (body.shape == null)
            {
                out.setTo(at.x, at.y, at.z);
            }
            else
            {
                out.setTo(body.x, body.y, body.z);
            }
        }

        // The middles between which canSee looks may be a little outside of the world, the origin of a ray not.
        private static function checked(origin:Vector3D):Vector3D
        {
            if (origin != null)
            {
                requireInWorld("a ray's origin", origin.x, origin.y, origin.z);
            }
            return origin;
        }

        private function begin(wanted:int, origin:Vector3D, direction:Vector3D, maxDistance:Number, filter:AgentFilter):void
        {
            _ray.aim(origin, direction);
            _ray.to = maxDistance;
            _rays.begin(_seen.table, _seen.pairs.trees);
            _found.begin(wanted, maxDistance, null, filter);
            _hitCount = 0;
            _search.begin(_seen.findExtents(), _ray.x, _ray.y, _ray.z, 0, 0, 0);
            _search.moveAlong(_ray.directionX, _ray.directionY, _ray.directionZ, maxDistance);
        }

        // The next row that counts and that the ray meets, or -1.
        private function next():int
        {
            var row:int = _search.next();
            while (row >= 0 && (!_found.admits(row) || !_rays.meets(row)))
            {
                row = _search.next();
            }
            return row;
        }

        // Finds the rows that the ray meets, and keeps how it meets them.
        private function collect():void
        {
            if (_hitOf.length < _seen.table.agents.length)
            {
                _hitOf.length = _seen.table.agents.length;
            }
            for (var row:int = next(); row >= 0; row = next())
            {
                if (_found.add(row, _ray.from))
                {
                    var at:int = 4 * _hitCount;
                    _hits[at] = _ray.from;
                    _hits[int(at + 1)] = _ray.normalX;
                    _hits[int(at + 2)] = _ray.normalY;
                    _hits[int(at + 3)] = _ray.normalZ;
                    _triangles[_hitCount] = _rays.triangle;
                    _hitOf[row] = _hitCount;
                    _hitCount++;
                    _search.limit = _ray.to = _found.limit;
                }
            }
        }

        // Writes how the ray meets a row.
        private function write(row:int, hit:RayHit):RayHit
        {
            var number:int = _hitOf[row];
            var at:int = 4 * number;
            var distance:Number = _hits[at];
            hit.agent = _seen.table.agents[row];
            hit.distance = distance;
            hit.triangle = _triangles[number];
            hit.point.setTo(_ray.x + distance * _ray.directionX, _ray.y + distance * _ray.directionY, _ray.z + distance * _ray.directionZ);
            hit.normal.setTo(_hits[int(at + 1)], _hits[int(at + 2)], _hits[int(at + 3)]);
            return hit;
        }
    }
}
