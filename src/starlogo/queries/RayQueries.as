package starlogo.queries
{
    import flash.geom.Vector3D;
    import starlogo.agents.Agent;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.geometry.requireInWorld;
    import starlogo.intersection.isAfter;
    import starlogo.intersection.ray.Ray;
    import starlogo.search.Body;

    use namespace engine;

    /**
     * Answers which agents a ray meets.
     *
     * @private
     */
    public final class RayQueries
    {
        private var _seen:QueryWorld;
        private var _bodies:QueryBodies;
        private var _found:Collector;
        private var _search:SweptBoxSearch;
        private var _rays:RowRays;
        private var _ray:Ray;

        // The last number of a hit is the triangle.
        private var _hits:Hits;
        private var _middleA:Vector3D = new Vector3D();
        private var _middleB:Vector3D = new Vector3D();

        /**
         * @param seen the agents that questions are about
         * @param bodies the bodies that ask
         * @param found collects the rows that the ray meets
         * @param search finds the rows near the ray
         */
        public function RayQueries(seen:QueryWorld, bodies:QueryBodies, found:Collector, search:SweptBoxSearch)
        {
            _seen = seen;
            _bodies = bodies;
            _found = found;
            _search = search;
            _rays = new RowRays(seen);
            _ray = _rays.ray;
            _hits = new Hits(found, RayHit);
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
            _hits.fit(hits, _found.end());
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
            // the ray always starts at the same place of the two, because rounding may let a ray that grazes something pass in one direction only
            var isTurned:Boolean = _middleA.x > _middleB.x || (_middleA.x == _middleB.x && isAfter(_middleA, _middleB));
            var from:Vector3D = isTurned ? _middleB : _middleA;
            var towards:Vector3D = isTurned ? _middleA : _middleB;
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
            for (var row:int = _found.nextOf(_search); row >= 0; row = _found.nextOf(_search))
            {
                if (row != rowA && row != rowB && _rays.meets(row))
                {
                    if (!_found.asks)
                    {
                        // any row will do
                        return false;
                    }
                    _found.add(row, _ray.from);
                }
            }
            return _found.end() == 0;
        }

        // Finds the middle of an agent's extents as it is now. While the model is loading it is the agent's place.
        private function findMiddle(agent:Agent, out:Vector3D):void
        {
            var at:Placement = _seen.placeOf(agent);
            var body:Body = _bodies.ofAgent(agent);
            if (body.shape == null)
            {
                out.setTo(at.x, at.y, at.z);
            }
            else
            {
                out.setTo(body.x, body.y, body.z);
            }
        }

        // A ray's origin must be in the world. The middles that canSee uses may be a little outside, so it does not call this.
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
            QuerySet.requirePositive("maxDistance", maxDistance);
            _ray.to = maxDistance;
            _found.begin(wanted, maxDistance, null, filter);
            _search.begin(_seen.findExtents(), _ray.x, _ray.y, _ray.z, 0, 0, 0);
            _search.moveAlong(_ray.directionX, _ray.directionY, _ray.directionZ, maxDistance);
        }

        // Finds the rows that the ray meets, and keeps how it meets them.
        private function collect():void
        {
            var ray:Ray = _ray;
            var numbers:Vector.<Number> = _hits.numbers;
            for (var row:int = _found.nextOf(_search); row >= 0; row = _found.nextOf(_search))
            {
                if (_rays.meets(row) && _found.add(row, ray.from))
                {
                    var at:int = _hits.put(row);
                    numbers[at] = ray.from;
                    numbers[int(at + 1)] = ray.x + ray.from * ray.directionX;
                    numbers[int(at + 2)] = ray.y + ray.from * ray.directionY;
                    numbers[int(at + 3)] = ray.z + ray.from * ray.directionZ;
                    numbers[int(at + 4)] = ray.normalX;
                    numbers[int(at + 5)] = ray.normalY;
                    numbers[int(at + 6)] = ray.normalZ;
                    numbers[int(at + 7)] = _rays.triangle;
                    _search.limit = ray.to = _found.limit;
                }
            }
        }

        // Writes how the ray meets a row.
        private function write(row:int, hit:RayHit):RayHit
        {
            var at:int = _hits.write(row, hit.point, hit.normal);
            hit.agent = _seen.table.agents[row];
            hit.distance = _hits.numbers[at];
            hit.triangle = _hits.numbers[int(at + 7)];
            return hit;
        }
    }
}
