package starlogo.queries
{
    import starlogo.intersection.ray.Ray;
    import starlogo.search.KeySort;

    /**
     * Keeps the surfaces of rows that a ray crosses, until it is known which rows are in the answer.
     *
     * @private
     */
    public final class RaySurfaces
    {
        private static const NUMBERS:int = 6;

        /** The number of surfaces. */
        public var count:int = 0;

        private var _seen:QueryWorld;

        // By surface: its row, its distance, its triangle or -1, and its point and normal.
        private var _rows:Vector.<int> = new Vector.<int>();
        private var _distances:Vector.<Number> = new Vector.<Number>();
        private var _triangles:Vector.<int> = new Vector.<int>();
        private var _numbers:Vector.<Number> = new Vector.<Number>();

        // By row: its first surface. Those of a row stand side by side.
        private var _firsts:Vector.<int> = new Vector.<int>();

        // The surfaces of the answer in their order, their distances, and the rank of the row of each surface.
        private var _order:Vector.<int> = new Vector.<int>();
        private var _keys:Vector.<Number> = new Vector.<Number>();
        private var _ranks:Vector.<int> = new Vector.<int>();
        private var _sort:KeySort = new KeySort();

        /** @param seen has the rows */
        public function RaySurfaces(seen:QueryWorld)
        {
            _seen = seen;
        }

        /** Begins without surfaces. */
        public function begin():void
        {
            count = 0;
        }

        /** Adds a surface of a row, after the row's other ones. @param ray begins at the surface, with the normal and the triangle there */
        public function add(row:int, ray:Ray):void
        {
            if (_firsts.length <= row)
            {
                _firsts.length = row + 1;
            }
            if (count == 0 || _rows[int(count - 1)] != row)
            {
                _firsts[row] = count;
            }
            var at:int = NUMBERS * count;
            _rows[count] = row;
            _distances[count] = ray.from;
            _triangles[count] = ray.triangle;
            _ranks[count] = _seen.table.list.ranks[row];
            _numbers[at] = ray.x + ray.from * ray.directionX;
            _numbers[at + 1] = ray.y + ray.from * ray.directionY;
            _numbers[at + 2] = ray.z + ray.from * ray.directionZ;
            _numbers[at + 3] = ray.normalX;
            _numbers[at + 4] = ray.normalY;
            _numbers[at + 5] = ray.normalZ;
            count++;
        }

        /** The distance of the first surface of a row that has one. */
        public function firstDistanceOf(row:int):Number
        {
            return _distances[_firsts[row]];
        }

        /** Keeps the surfaces of the rows of an answer, and sorts them. */
        public function arrange(found:Collector):void
        {
            var kept:int = 0;
            for (var i:int = 0; i < found.count; i++)
            {
                var row:int = found.rows[i];
                for (var surface:int = _firsts[row]; surface < count && _rows[surface] == row; surface++)
                {
                    _order[kept] = surface;
                    _keys[kept] = _distances[surface];
                    kept++;
                }
            }
            count = kept;
            _sort.sort(_order, _keys, kept, _ranks);
        }

        /** Writes a surface of the answer. Returns its row. */
        public function write(index:int, hit:RayHit):int
        {
            var surface:int = _order[index];
            var at:int = NUMBERS * surface;
            hit.agent = _seen.table.list.agents[_rows[surface]];
            hit.distance = _distances[surface];
            hit.point.setTo(_numbers[at], _numbers[at + 1], _numbers[at + 2]);
            hit.normal.setTo(_numbers[at + 3], _numbers[at + 4], _numbers[at + 5]);
            hit.triangle = _triangles[surface];
            return _rows[surface];
        }
    }
}
