package starlogo.queries.rays
{
    import starlogo.convex.ContactPoint;
    import starlogo.data.IntSet;
    import starlogo.data.SortableIntList;
    import starlogo.engine;
    import starlogo.intersection.ray.Ray;
    import starlogo.intersection.ray.RayCrossing;
    import starlogo.queries.RayHit;
    import starlogo.queries.SeenAgents;
    import starlogo.queries.trees.Collector;

    use namespace engine;

    /**
     * The hits of a ray with rows. A Collector has each row with the distance of its first hit, and decides which rows the answer has.
     *
     * @private
     */
    public final class RayHits
    {
        private var _seen:SeenAgents;
        private var _collector:Collector;
        private var _writer:HitWriter;

        // The hits: the row of each, with the distance as its key. The hits of a row stand side by side.
        private var _hits:SortableIntList = new SortableIntList();

        // By hit: the list index of its row, and its contact.
        private var _listIndices:Vector.<int> = new Vector.<int>();
        private var _contacts:Vector.<ContactPoint> = new Vector.<ContactPoint>();

        // The rows of the answer, and its hits in their order.
        private var _rows:IntSet = new IntSet();
        private var _answer:SortableIntList = new SortableIntList();

        /** @param seen has the rows */
        public function RayHits(seen:SeenAgents)
        {
            _seen = seen;
            _writer = new HitWriter(seen, RayHit);
        }

        /** Begins a question without hits. add() gives its collector the rows. */
        public function begin(collector:Collector):void
        {
            _collector = collector;
            _hits.count = 0;
        }

        /** Adds the hit where a ray enters a row, after the row's other ones. */
        public function add(row:int, ray:Ray, entry:RayCrossing):void
        {
            var index:int = _hits.count;
            if (index == 0 || _hits.values[int(index - 1)] != row)
            {
                _collector.add(row, entry.distance);
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

        /** Adds the hits of a ray with the surfaces of a row, after those of other rows. A surface at exactly the ray's end is hit. */
        public function addSurfaces(row:int, ray:Ray, surfaces:SurfaceCrossings):void
        {
            for (var i:int = 0; i < surfaces.count; i++)
            {
                if (surfaces.surfaceAt(i).distance <= ray.to)
                {
                    add(row, ray, surfaces.surfaceAt(i));
                }
            }
        }

        /** Ends the search. The answer has all hits of the collector's rows, sorted by distance. */
        public function end():void
        {
            _rows.clear(_seen.table.listed.rowCapacity);
            for (var i:int = _collector.end() - 1; i >= 0; i--)
            {
                _rows.add(_collector.rowAt(i));
            }
            _answer.count = 0;
            for (var hit:int = 0; hit < _hits.count; hit++)
            {
                if (_rows.has(_hits.values[hit]))
                {
                    _answer.add(hit, _hits.keys[hit]);
                }
            }
            _answer.sortFirst(_answer.count, _listIndices);
        }

        /** Writes the first hit of the answer. Returns it, or null if there is none. */
        public function writeFirst(out:RayHit):RayHit
        {
            return _answer.count == 0 ? null : write(0, out || new RayHit());
        }

        /** Writes all hits of the answer into a list. Returns the list. */
        public function writeAll(out:Vector.<RayHit>):Vector.<RayHit>
        {
            _writer.resize(out, _answer.count);
            for (var i:int = 0; i < out.length; i++)
            {
                write(i, out[i]);
            }
            return out;
        }

        private function write(index:int, out:RayHit):RayHit
        {
            var hit:int = _answer.values[index];
            _writer.write(_hits.values[hit], _contacts[hit], out);
            out.distance = _answer.keys[index];
            return out;
        }
    }
}
