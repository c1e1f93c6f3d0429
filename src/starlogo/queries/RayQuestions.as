package starlogo.queries
{
    import flash.geom.Vector3D;
    import starlogo.agents.Agent;
    import starlogo.broadphase.Extents;
    import starlogo.engine;
    import starlogo.intersection.ray.Ray;
    import starlogo.search.AgentTable;

    use namespace engine;

    /**
     * The questions about what a ray meets.
     *
     * @private
     */
    public final class RayQuestions
    {
        private var _seen:SeenAgents;
        private var _rows:FilteredRows;
        private var _answers:Answers;
        private var _order:DistanceOrder = new DistanceOrder();
        private var _rays:RowRays = new RowRays();

        // Members that do not count.
        private var _except:int = -1;
        private var _exceptToo:int = -1;

        // What the ray meets: the members, how far along it, and the normals there; by member, where it is among these.
        private var _found:Vector.<int> = new Vector.<int>();
        private var _distances:Vector.<Number> = new Vector.<Number>();
        private var _normals:Vector.<Number> = new Vector.<Number>();
        private var _normalOf:Vector.<int> = new Vector.<int>();

        // By how many questions are under way: the hits of which accepts is asked. Hits that lists have no use for at present.
        private var _asked:Vector.<Vector.<RayHit>> = new Vector.<Vector.<RayHit>>();
        private var _spare:Vector.<RayHit> = new Vector.<RayHit>();
        private var _spareCount:int = 0;

        private var _blocking:RayHit = new RayHit();
        private var _middle:Vector3D = new Vector3D();
        private var _towards:Vector3D = new Vector3D();

        /**
         * @param seen the agents that are asked about
         * @param rows applies filters to them
         * @param answers asks the rest of the filters
         */
        public function RayQuestions(seen:SeenAgents, rows:FilteredRows, answers:Answers)
        {
            _seen = seen;
            _rows = rows;
            _answers = answers;
        }

        /** As AgentQueries.cast. */
        public function cast(origin:Vector3D, direction:Vector3D, maxDistance:Number, filter:AgentFilter, hit:RayHit):RayHit
        {
            _rays.ray.aim(origin, direction);
            _rays.limit = maxDistance;
            begin();
            if (filter != null && filter.accepts != null)
            {
                return findAccepted(filter, hit);
            }
            var member:int = findFirst(_rows.of(filter));
            if (member < 0)
            {
                return null;
            }
            hit ||= new RayHit();
            write(hit, member, 0, 0);
            return hit;
        }

        /** As AgentQueries.castAll. */
        public function castAll(origin:Vector3D, direction:Vector3D, maxDistance:Number, filter:AgentFilter, out:Vector.<RayHit>):Vector.<RayHit>
        {
            _rays.ray.aim(origin, direction);
            _rays.limit = maxDistance;
            begin();
            var hits:Vector.<RayHit> = out || new Vector.<RayHit>();
            list(_rows.of(filter), hits);
            if (filter != null && filter.accepts != null)
            {
                setLength(hits, keepAccepted(hits, filter.accepts, int.MAX_VALUE));
            }
            return hits;
        }

        /** As AgentQueries.canSee. */
        public function canSee(a:Agent, b:Agent, filter:AgentFilter):Boolean
        {
            findMiddle(a, _middle);
            findMiddle(b, _towards);
            _towards.decrementBy(_middle);
            var distance:Number = Math.sqrt(_towards.x * _towards.x + _towards.y * _towards.y + _towards.z * _towards.z);
            if (distance == 0)
            {
                // whatever is there
                _towards.z = 1;
            }
            _rays.ray.aim(_middle, _towards);
            _rays.limit = distance;
            begin();
            _except = _seen.memberOf(a);
            _exceptToo = _seen.memberOf(b);
            if (filter != null && filter.accepts != null)
            {
                var isBlocked:Boolean = findAccepted(filter, _blocking) != null;
                _blocking.agent = null;
                return !isBlocked;
            }
            return next(_rows.of(filter)) < 0;
        }

        // Where the middle of an agent's extents is now; its place while its model is loading.
        private function findMiddle(agent:Agent, out:Vector3D):void
        {
            var row:int = _seen.rowOfNow(agent);
            var table:AgentTable = _seen.table;
            // field by field: of Numbers that it passes V8 makes objects
            if (table.shapes[row] == null)
            {
                out.x = agent.x;
                out.y = agent.y;
                out.z = agent.z;
            }
            else
            {
                out.x = table.extents.x[row];
                out.y = table.extents.y[row];
                out.z = table.extents.z[row];
            }
            table.endGuests();
        }

        // Begins with the ray that is aimed, up to the limit that is set, and the boxes that it meets.
        private function begin():void
        {
            _rays.begin(_seen.table, _seen.strategy);
            _except = _exceptToo = -1;
            var boxes:ExtentsTree = _seen.extents;
            var ray:Ray = _rays.ray;
            boxes.x = ray.x;
            boxes.y = ray.y;
            boxes.z = ray.z;
            boxes.directionX = ray.directionX;
            boxes.directionY = ray.directionY;
            boxes.directionZ = ray.directionZ;
            boxes.limit = _rays.limit;
            boxes.beginRay();
        }

        // The next member that the ray meets, or -1; those that are excluded cost no test.
        private function next(test:RowTest):int
        {
            var rows:Vector.<int> = _seen.table.rows;
            var boxes:ExtentsTree = _seen.extents;
            var member:int = boxes.nextOnRay();
            while (member >= 0)
            {
                if (member != _except && member != _exceptToo && (test == null || test.accepts(member)) && _rays.meets(rows[member]))
                {
                    return member;
                }
                member = boxes.nextOnRay();
            }
            return -1;
        }

        // The member that is met first, of several the first in the list; its distance and normal are the first of the columns.
        private function findFirst(test:RowTest):int
        {
            var boxes:ExtentsTree = _seen.extents;
            var first:int = -1;
            var member:int = next(test);
            while (member >= 0)
            {
                if (first < 0 || _rays.distance < _distances[0] || member < first)
                {
                    first = member;
                    note(0);
                    boxes.limit = _rays.limit = _rays.distance;
                }
                member = next(test);
            }
            return first;
        }

        // Lists every hit, but for accepts.
        private function list(test:RowTest, out:Vector.<RayHit>):void
        {
            var count:int = 0;
            if (_normalOf.length < _seen.count)
            {
                _normalOf.length = _seen.count;
            }
            var member:int = next(test);
            while (member >= 0)
            {
                _found[count] = member;
                _normalOf[member] = count;
                note(count);
                count++;
                member = next(test);
            }
            _order.sort(_found, _distances, count);
            setLength(out, count);
            for (var i:int = 0; i < count; i++)
            {
                write(out[i], _found[i], i, _normalOf[_found[i]]);
            }
        }

        // Keeps the distance and the normal of what was met last.
        private function note(at:int):void
        {
            _distances[at] = _rays.distance;
            at *= 3;
            _normals[at] = _rays.normalX;
            _normals[int(at + 1)] = _rays.normalY;
            _normals[int(at + 2)] = _rays.normalZ;
        }

        private function write(hit:RayHit, member:int, at:int, normal:int):void
        {
            var distance:Number = _distances[at];
            var ray:Ray = _rays.ray;
            hit.agent = _seen.agentOf(member);
            hit.distance = distance;
            hit.point.x = ray.x + distance * ray.directionX;
            hit.point.y = ray.y + distance * ray.directionY;
            hit.point.z = ray.z + distance * ray.directionZ;
            normal *= 3;
            hit.normal.x = _normals[normal];
            hit.normal.y = _normals[int(normal + 1)];
            hit.normal.z = _normals[int(normal + 2)];
        }

        // Gives a list so many hits; those that it has no use for are kept for others. One by one, as in Answers.shorten.
        private function setLength(hits:Vector.<RayHit>, length:int):void
        {
            while (hits.length > length)
            {
                var hit:RayHit = hits.pop();
                if (hit != null)
                {
                    hit.agent = null;
                    _spare[_spareCount] = hit;
                    _spareCount++;
                }
            }
            for (var i:int = 0; i < length; i++)
            {
                if (i == hits.length || hits[i] == null)
                {
                    hits[i] = takeSpare();
                }
            }
        }

        private function takeSpare():RayHit
        {
            if (_spareCount > 0)
            {
                _spareCount--;
                return _spare[_spareCount];
            }
            return new RayHit();
        }

        // Asks accepts of the hits, the nearest first, until one is accepted: copies that one.
        private function findAccepted(filter:AgentFilter, hit:RayHit):RayHit
        {
            if (_seen.asking == _asked.length)
            {
                _asked.push(new Vector.<RayHit>());
            }
            var hits:Vector.<RayHit> = _asked[_seen.asking];
            list(_rows.of(filter), hits);
            var isAccepted:Boolean = keepAccepted(hits, filter.accepts, 1) > 0;
            if (isAccepted)
            {
                hit ||= new RayHit();
                copy(hits[0], hit);
            }
            setLength(hits, 0);
            return isAccepted ? hit : null;
        }

        // Puts those hits first, of the list that was made last, that accepts says yes to, until these are so many; returns how many.
        private function keepAccepted(hits:Vector.<RayHit>, accepts:Function, most:int):int
        {
            var accepted:Vector.<Agent> = _answers.keepAccepted(_found, 0, hits.length, accepts, most);
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
            return kept;
        }

        private static function copy(from:RayHit, to:RayHit):void
        {
            to.agent = from.agent;
            to.distance = from.distance;
            to.point.copyFrom(from.point);
            to.normal.copyFrom(from.normal);
        }
    }
}
