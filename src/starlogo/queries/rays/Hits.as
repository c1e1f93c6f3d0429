package starlogo.queries.rays
{
    import starlogo.convex.ContactPoint;
    import starlogo.data.SortableIntList;
    import starlogo.engine;
    import starlogo.intersection.ray.Ray;
    import starlogo.intersection.ray.RayEntry;
    import starlogo.queries.CastHit;
    import starlogo.queries.SeenAgents;
    import starlogo.queries.trees.Collector;
    import starlogo.search.Body;

    use namespace engine;

    /**
     * Keeps how a ray or a moving body meets rows, until the answer of the question is known.
     *
     * @private
     */
    public final class Hits
    {
        private var _seen:SeenAgents;

        // The hits: the row of each, with the distance or time as its key. The hits of a row stand side by side.
        private var _hits:SortableIntList = new SortableIntList();

        // By hit: the rank of its row, and its contact.
        private var _ranks:Vector.<int> = new Vector.<int>();
        private var _contacts:Vector.<ContactPoint> = new Vector.<ContactPoint>();

        // By row: its first hit.
        private var _firsts:Vector.<int> = new Vector.<int>();

        // The hits of the answer, in their order.
        private var _answer:SortableIntList = new SortableIntList();

        private var _triangle:TriangleOfHit = new TriangleOfHit();

        /** @param seen has the rows */
        public function Hits(seen:SeenAgents)
        {
            _seen = seen;
        }

        /** Begins without hits. */
        public function clear():void
        {
            _hits.count = 0;
        }

        /**
         * Adds a hit of a row, after the row's other ones.
         *
         * @param key the distance or time
         * @return the contact. The caller writes to it
         */
        public function add(row:int, key:Number):ContactPoint
        {
            var index:int = _hits.count;
            if (_firsts.length <= row)
            {
                _firsts.length = row + 1;
            }
            if (index == 0 || _hits.values[int(index - 1)] != row)
            {
                _firsts[row] = index;
            }
            if (index == _contacts.length)
            {
                _contacts.push(new ContactPoint());
            }
            _hits.add(row, key);
            _ranks[index] = _seen.table.list.ranks[row];
            return _contacts[index];
        }

        /** Adds the hit where a ray enters a row, with the normal and the triangle there. */
        public function addEntry(row:int, ray:Ray, entry:RayEntry):void
        {
            var contact:ContactPoint = add(row, entry.distance);
            contact.x = ray.x + entry.distance * ray.directionX;
            contact.y = ray.y + entry.distance * ray.directionY;
            contact.z = ray.z + entry.distance * ray.directionZ;
            contact.setNormal(entry.normalX, entry.normalY, entry.normalZ);
            contact.triangle = entry.triangle;
        }

        /** The distance or time of the first hit of a row that has one. */
        public function firstKeyOf(row:int):Number
        {
            return _hits.keys[_firsts[row]];
        }

        /** Ends a collector's search. The answer has the hits of the rows that it has found, sorted by their keys. Returns how many they are. */
        public function end(collector:Collector):int
        {
            var rows:int = collector.end();
            _answer.count = 0;
            for (var i:int = 0; i < rows; i++)
            {
                var row:int = collector.rowAt(i);
                for (var hit:int = _firsts[row]; hit < _hits.count && _hits.values[hit] == row; hit++)
                {
                    _answer.add(hit, _hits.keys[hit]);
                }
            }
            if (_answer.count > rows)
            {
                // between hits of one row there may be others
                _answer.sortFirst(_answer.count, _ranks);
            }
            return _answer.count;
        }

        /** The body of a hit of the answer. */
        public function bodyOf(index:int):Body
        {
            return _seen.table.bodyOf(rowOf(index));
        }

        private function rowOf(index:int):int
        {
            return _hits.values[_answer.values[index]];
        }

        /** The distance or time of a hit of the answer. */
        public function keyOf(index:int):Number
        {
            return _answer.keys[index];
        }

        /** The contact of a hit of the answer. */
        public function contactOf(index:int):ContactPoint
        {
            return _contacts[_answer.values[index]];
        }

        /** Writes a hit of the answer, all but its distance or time. */
        public function fillHit(index:int, hit:CastHit):void
        {
            var from:ContactPoint = contactOf(index);
            hit.agent = _seen.table.list.agentsByRow[rowOf(index)];
            // not setTo, because a game in JavaScript may have given a hit any objects with x, y and z
            hit.point.x = from.x;
            hit.point.y = from.y;
            hit.point.z = from.z;
            hit.normal.x = from.normalX;
            hit.normal.y = from.normalY;
            hit.normal.z = from.normalZ;
            hit.triangle = from.triangle;
            _triangle.fillTriangle(bodyOf(index), hit);
        }
    }
}
