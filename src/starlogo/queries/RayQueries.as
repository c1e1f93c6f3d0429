package starlogo.queries
{
    import flash.geom.Vector3D;
    import starlogo.agents.Agent;
    import starlogo.convex.ContactPoint;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.geometry.requireInWorld;
    import starlogo.intersection.isAfter;
    import starlogo.intersection.ray.Ray;
    import starlogo.search.Body;

    use namespace engine;

    /**
     * Answers which agents a ray meets, and where.
     *
     * @private
     */
    public final class RayQueries
    {
        private var _set:QuerySet;
        private var _rowRays:RowRays;
        private var _ray:Ray = new Ray();

        private var _hits:Hits;
        private var _triangle:TriangleOfHit = new TriangleOfHit();
        private var _surfaces:RaySurfaces;
        private var _middleA:Vector3D = new Vector3D();
        private var _middleB:Vector3D = new Vector3D();

        /** @param questions what questions work with */
        public function RayQueries(questions:QuerySet)
        {
            _set = questions;
            _rowRays = new RowRays(questions.seen);
            _hits = new Hits(questions.found, RayHit);
            _surfaces = new RaySurfaces(questions.seen);
        }

        /** See AgentQueries.cast. */
        public function cast(origin:Vector3D, direction:Vector3D, maxDistance:Number, filter:AgentFilter, hit:RayHit):RayHit
        {
            begin(1, checked(origin), direction, maxDistance, filter);
            collect();
            return _set.found.end() == 0 ? null : write(0, hit || new RayHit());
        }

        /** See AgentQueries.castAll. */
        public function castAll(origin:Vector3D, direction:Vector3D, maxDistance:Number, filter:AgentFilter, out:Vector.<RayHit>,
                allSurfaces:Boolean):Vector.<RayHit>
        {
            var hits:Vector.<RayHit> = out || new Vector.<RayHit>();
            begin(Collector.ALL, checked(origin), direction, maxDistance, filter);
            if (allSurfaces)
            {
                collectSurfaces();
                _set.found.end();
                _surfaces.arrange(_set.found);
                _hits.fit(hits, _surfaces.count);
            }
            else
            {
                collect();
                _hits.fit(hits, _set.found.endSorted());
            }
            for (var i:int = 0; i < hits.length; i++)
            {
                if (allSurfaces)
                {
                    writeTriangle(_surfaces.write(i, hits[i]), hits[i]);
                }
                else
                {
                    write(i, hits[i]);
                }
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
            var rowA:int = _set.seen.rowOf(a);
            var rowB:int = _set.seen.rowOf(b);
            var found:Collector = begin(1, from, towards, distance, filter);
            var way:SweptBoxSearch = _set.boxSearch;
            for (var row:int = found.nextOf(way); row >= 0; row = found.nextOf(way))
            {
                if (row != rowA && row != rowB && _rowRays.findHit(row, _ray))
                {
                    if (found.filter.accepts == null)
                    {
                        // any row will do
                        return false;
                    }
                    found.add(row, _ray.from);
                }
            }
            return found.end() == 0;
        }

        // Finds the middle of an agent's extents as it is now. While the model is loading it is the agent's place.
        private function findMiddle(agent:Agent, out:Vector3D):void
        {
            var at:Placement = _set.seen.placeOf(agent);
            var body:Body = _set.bodyOf(agent);
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

        private function begin(wanted:int, origin:Vector3D, direction:Vector3D, maxDistance:Number, filter:AgentFilter):Collector
        {
            var ray:Ray = _ray;
            ray.aim(origin, direction);
            QuerySet.requireNotNegative("maxDistance", maxDistance);
            ray.to = maxDistance;
            _set.found.begin(wanted, maxDistance, null, filter);
            _set.boxSearch.begin(_set.seen.findExtents(), ray.x, ray.y, ray.z, 0, 0, 0);
            _set.boxSearch.moveAlong(ray.directionX, ray.directionY, ray.directionZ, maxDistance);
            return _set.found;
        }

        // Finds the rows that the ray meets, and keeps how it meets them.
        private function collect():void
        {
            var found:Collector = _set.found;
            var way:SweptBoxSearch = _set.boxSearch;
            var ray:Ray = _ray;
            for (var row:int = found.nextOf(way); row >= 0; row = found.nextOf(way))
            {
                if (_rowRays.findHit(row, _ray) && found.add(row, ray.from))
                {
                    var contact:ContactPoint = _hits.newContact(row, ray.triangle);
                    contact.x = ray.x + ray.from * ray.directionX;
                    contact.y = ray.y + ray.from * ray.directionY;
                    contact.z = ray.z + ray.from * ray.directionZ;
                    contact.setNormal(ray.normalX, ray.normalY, ray.normalZ);
                    way.limit = ray.to = found.limit;
                }
            }
        }

        // Finds the rows that the ray meets, and keeps all surfaces that it crosses.
        private function collectSurfaces():void
        {
            var found:Collector = _set.found;
            var way:SweptBoxSearch = _set.boxSearch;
            _surfaces.begin();
            for (var row:int = found.nextOf(way); row >= 0; row = found.nextOf(way))
            {
                if (_rowRays.findSurfaces(row, _ray, _surfaces))
                {
                    found.add(row, _surfaces.firstDistanceOf(row));
                }
            }
        }

        private function writeTriangle(row:int, hit:RayHit):void
        {
            var from:TriangleOfHit = _triangle;
            from.read(_set.seen.table.bodyOf(row), hit.triangle, hit.point, hit.weights);
            hit.mesh = from.mesh;
            hit.material = from.material;
            hit.materialName = from.materialName;
        }

        // Writes how the ray meets a row of the answer.
        private function write(index:int, hit:RayHit):RayHit
        {
            _hits.write(index, hit.point, hit.normal);
            hit.triangle = _hits.triangleOf(index);
            hit.agent = _set.found.agentAt(index);
            hit.distance = _set.found.keys[index];
            writeTriangle(_set.found.rows[index], hit);
            return hit;
        }
    }
}
