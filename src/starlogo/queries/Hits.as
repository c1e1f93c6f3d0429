package starlogo.queries
{
    import flash.geom.Vector3D;

    /**
     * Keeps how a ray or a moving body meets rows, until the answer of the question is known. It also keeps the RayHits or ShapeHits that no
     * list needs at present, for lists that need more.
     *
     * @private
     */
    public final class Hits
    {
        private static const PER_HIT:int = 8;

        /**
         * Eight numbers for each hit: the distance or the time, the point, the normal, and one more. Write all eight after <code>put()</code>, in
         * this order.
         */
        public var numbers:Vector.<Number> = new Vector.<Number>();

        private var _found:Collector;
        private var _type:Class;
        private var _spare:Array = [];

        // By row: the index of its numbers.
        private var _indices:Vector.<int> = new Vector.<int>();

        /**
         * @param found collects the rows that are met
         * @param type RayHit or ShapeHit
         */
        public function Hits(found:Collector, type:Class)
        {
            _found = found;
            _type = type;
        }

        /** Returns the index where the numbers begin of the row that was collected last. */
        public function put(row:int):int
        {
            if (_indices.length <= row)
            {
                _indices.length = row + 1;
            }
            var index:int = PER_HIT * (_found.count - 1);
            _indices[row] = index;
            return index;
        }

        /** Writes the point and the normal of a row's hit. Returns the index where the row's numbers begin. */
        public function write(row:int, point:Vector3D, normal:Vector3D):int
        {
            var from:Vector.<Number> = numbers;
            var at:int = _indices[row];
            point.setTo(from[int(at + 1)], from[int(at + 2)], from[int(at + 3)]);
            normal.setTo(from[int(at + 4)], from[int(at + 5)], from[int(at + 6)]);
            return at;
        }

        /**
         * Makes a list have a number of hits. It removes surplus hits one at a time, because V8 frees an array's memory if its length is set to
         * less.
         *
         * @param hits a list of hits of the type
         */
        public function fit(hits:Object, length:int):void
        {
            while (hits.length > length)
            {
                var hit:Object = hits.pop();
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
                    var spare:Object = _spare.pop();
                    if (spare == null)
                    {
                        spare = new _type();
                    }
                    hits[i] = spare;
                }
            }
        }
    }
}
