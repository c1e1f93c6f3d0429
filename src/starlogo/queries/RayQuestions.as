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

        // A second row that does not count, or -1.
        private var _skippedToo:int = -1;

        // The rows that the ray meets, with their distances, not squared; the hits in the order in which they are found; and by row, the number
        // of its hit.
        private var _found:FoundRows;
        private var _hits:Vector.<RayHit> = new Vector.<RayHit>();
        private var _hitOf:Vector.<int> = new Vector.<int>();

        // Empty lists for the hits for which accepts is called. There are several, because accepts may ask questions itself. Then hits that no
        // list needs at present.
        private var _lists:Vector.<Vector.<RayHit>> = new Vector.<Vector.<RayHit>>();
        private var _spare:Vector.<RayHit> = new Vector.<RayHit>();

        private var _middleA:Vector3D = new Vector3D();
        private var _middleB:Vector3D = new Vector3D();

        /** @param seen the agents that questions are about */
        public function RayQuestions(seen:SeenAgents)
        {
            _seen = seen;
            _found = new FoundRows(seen);
        }

        /** See AgentQueries.cast. */
        public function cast(origin:Vector3D, direction:Vector3D, maxDistance:Number, filter:AgentFilter, hit:RayHit):RayHit
        {
            begin(checked(origin), direction, maxDistance, filter);
            if (filter != null && filter.accepts != null)
            {
                return findAccepted(hit);
            }
            var first:int = -1;
            for (var row:int = next(); row >= 0; row = next())
            {
                if (first < 0 || _ray.from < hit.distance || _seen.table.ranks[row] < _seen.table.ranks[first])
                {
                    first = row;
                    hit ||= new RayHit();
                    write(row, hit);
                    _search.limit = _ray.to = _ray.from;
                }
            }
            return first < 0 ? null : hit;
        }

        /** See AgentQueries.castAll. */
        public function castAll(origin:Vector3D, direction:Vector3D, maxDistance:Number, filter:AgentFilter, out:Vector.<RayHit>):Vector.<RayHit>
        {
            begin(checked(origin), direction, maxDistance, filter);
            var hits:Vector.<RayHit> = out || new Vector.<RayHit>();
            list(hits);
            if (filter != null && filter.accepts != null)
            {
                keepAccepted(hits, FoundRows.ALL);
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
            begin(from, towards, distance, filter);
            _found.skipped = _seen.rowOf(a);
            _skippedToo = _seen.rowOf(b);
            var most:int = FoundRows.toFind(1, filter);
            for (var row:int = next(); row >= 0; row = _found.count < most ? next() : -1)
            {
                _found.add(row, _ray.from);
            }
            return _found.countAccepted(1) == 0;
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

        private function begin(origin:Vector3D, direction:Vector3D, maxDistance:Number, filter:AgentFilter):void
        {
            _ray.aim(origin, direction);
            _ray.to = maxDistance;
            _rays.begin(_seen.table, _seen.pairs.trees);
            _found.begin(FoundRows.ALL, Infinity, null, filter);
            _skippedToo = -1;
            _search.begin(_seen.findExtents(), _ray.x, _ray.y, _ray.z, 0, 0, 0);
            _search.moveAlong(_ray.directionX, _ray.directionY, _ray.directionZ, maxDistance);
        }

        // The next row that counts and that the ray meets, or -1.
        private function next():int
        {
            var row:int = _search.next();
            while (row >= 0 && (row == _skippedToo || !_found.wants(row) || !_rays.meets(row)))
            {
                row = _search.next();
            }
            return row;
        }

        // Lists every hit, without calling accepts.
        private function list(out:Vector.<RayHit>):void
        {
            _hitOf.length = Math.max(_hitOf.length, _seen.table.agents.length);
            for (var row:int = next(); row >= 0; row = next())
            {
                var count:int = _found.count;
                if (count == _hits.length)
                {
                    _hits.push(new RayHit());
                }
                write(row, _hits[count]);
                _hitOf[row] = count;
                _found.add(row, _ray.from);
            }
            _found.sort();
            setLength(out, _found.count);
            for (var i:int = 0; i < out.length; i++)
            {
                copy(_hits[_hitOf[_found.rows[i]]], out[i]);
            }
        }

        // Writes how the ray meets a row. It must be the row that it met last.
        private function write(row:int, hit:RayHit):void
        {
            var distance:Number = _ray.from;
            hit.agent = _seen.table.agents[row];
            hit.distance = distance;
            hit.triangle = _rays.triangle;
            hit.point.setTo(_ray.x + distance * _ray.directionX, _ray.y + distance * _ray.directionY, _ray.z + distance * _ray.directionZ);
            hit.normal.setTo(_ray.normalX, _ray.normalY, _ray.normalZ);
        }

        // Makes a list have this many hits. Surplus hits are kept for other lists. It removes them one at a time, for the reason that
        // FoundRows.shorten gives.
        private function setLength(hits:Vector.<RayHit>, length:int):void
        {
            while (hits.length > length)
            {
                var hit:RayHit = hits.pop();
                if (hit != null)
                {
                    hit.agent = null;
                    _spare.push(hit);
                }
            }
            for (var i:int = 0; i < length; i++)
            {
                if (i == hits.length || hits[i] == null)
                {
                    hits[i] = _spare.pop() || new RayHit();
                }
            }
        }

        // Calls accepts for the hits, beginning with the nearest, until one is accepted. Copies that hit.
        private function findAccepted(hit:RayHit):RayHit
        {
            var hits:Vector.<RayHit> = _lists.pop() || new Vector.<RayHit>();
            list(hits);
            keepAccepted(hits, 1);
            var nearest:RayHit = null;
            if (hits.length > 0)
            {
                nearest = hit || new RayHit();
                copy(hits[0], nearest);
            }
            setLength(hits, 0);
            _lists.push(hits);
            return nearest;
        }

        // Calls accepts for the hits of the list that was made last, until enough are accepted. Keeps only the accepted hits.
        private function keepAccepted(hits:Vector.<RayHit>, most:int):void
        {
            var accepted:Vector.<Agent> = _found.keepAccepted(0, most);
            var kept:int = 0;
            for (var i:int = 0; i < hits.length && kept < accepted.length; i++)
            {
                var hit:RayHit = hits[i];
                if (hit.agent === accepted[kept])
                {
                    hits[i] = hits[kept];
                    hits[kept] = hit;
                    kept++;
                }
            }
            setLength(hits, kept);
        }

        private static function copy(from:RayHit, to:RayHit):void
        {
            to.agent = from.agent;
            to.distance = from.distance;
            to.triangle = from.triangle;
            to.point.copyFrom(from.point);
            to.normal.copyFrom(from.normal);
        }
    }
}
