package starlogo.queries.rays
{
    import starlogo.convex.ContactPoint;
    import starlogo.data.SortableIntList;
    import starlogo.engine;
    import starlogo.intersection.ray.Ray;
    import starlogo.intersection.ray.RayCrossing;
    import starlogo.queries.RayHit;
    import starlogo.queries.SeenAgents;
    import starlogo.queries.trees.Collector;

    use namespace engine;

    /**
     * Keeps how a ray meets rows, until the answer of the question is known.
     *
     * @private
     */
    public final class RayHits
    {
        private var _seen:SeenAgents;

        // The hits: the row of each, with the distance as its key. The hits of a row stand side by side.
        private var _hits:SortableIntList = new SortableIntList();

        // By hit: the list index of its row, and its contact.
        private var _listIndices:Vector.<int> = new Vector.<int>();
        private var _contacts:Vector.<ContactPoint> = new Vector.<ContactPoint>();

        // By row: its first hit.
        private var _firstHitByRow:Vector.<int> = new Vector.<int>();

        // The hits of the answer, in their order.
        private var _answer:SortableIntList = new SortableIntList();
        private var _writer:HitWriter;

        /** @param seen has the rows */
        public function RayHits(seen:SeenAgents)
        {
            _seen = seen;
            _writer = new HitWriter(seen);
        }

        /** Begins without hits. */
        public function clear():void
        {
            _hits.count = 0;
        }

        /** Adds the hit where a ray enters a row, after the row's other ones. */
        public function add(row:int, ray:Ray, entry:RayCrossing):void
        {
            var index:int = _hits.count;
            if (_firstHitByRow.length <= row)
            {
                _firstHitByRow.length = row + 1;
            }
            if (index == 0 || _hits.values[int(index - 1)] != row)
            {
                _firstHitByRow[row] = index;
            }
            if (index == _contacts.length)
            {
                _contacts.push(new ContactPoint());
            }
            _hits.add(row, entry.distance);
            _listIndices[index] = _seen.table.listed.listIndices[row];
            var contact:ContactPoint = _contacts[index];
            contact.x = ray.origin.x + entry.distance * ray.direction.x;
            contact.y = ray.origin.y + entry.distance * ray.direction.y;
            contact.z = ray.origin.z + entry.distance * ray.direction.z;
            contact.setNormal(entry.normal.x, entry.normal.y, entry.normal.z);
            contact.triangle = entry.triangle;
        }

        /** The distance of the first hit of a row that has one. */
        public function firstDistanceOf(row:int):Number
        {
            return _hits.keys[_firstHitByRow[row]];
        }

        /** Ends a collector's search. The answer has the hits of the rows that it has found, sorted by distance. Returns how many they are. */
        public function end(collector:Collector):int
        {
            var rows:int = collector.end();
            _answer.count = 0;
            for (var i:int = 0; i < rows; i++)
            {
                var row:int = collector.rowAt(i);
                for (var hit:int = _firstHitByRow[row]; hit < _hits.count && _hits.values[hit] == row; hit++)
                {
                    _answer.add(hit, _hits.keys[hit]);
                }
            }
            if (_answer.count > rows)
            {
                // between hits of one row there may be others
                _answer.sortFirst(_answer.count, _listIndices);
            }
            return _answer.count;
        }

        /** Writes a hit of the answer. Returns it. */
        public function writeHit(index:int, out:RayHit):RayHit
        {
            var hit:int = _answer.values[index];
            _writer.write(_hits.values[hit], _contacts[hit], out);
            out.distance = _answer.keys[index];
            return out;
        }
    }
}
