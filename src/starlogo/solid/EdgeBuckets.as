package starlogo.solid
{
    /**
     * The edges of triangles, in buckets: those between the same two vertices are in the same one. The player's own sort is what brings
     * them together fastest, but it sorts all that it is given at once; a bucket takes it a millisecond, unless edges crowd at a few vertices.
     */
    internal final class EdgeBuckets
    {
        private static const EDGES_PER_BUCKET:int = 3000;

        private var _vertexCount:Number;
        private var _bucketsPerVertex:Number;

        // Of each bucket's edges the number of the two vertices' pair, and which edge it is, inverted from the higher to the lower.
        private var _pairs:Vector.<Array>;
        private var _edges:Vector.<Array>;

        /**
         * @param vertexCount how many vertices there are
         * @param edgeCount about how many edges there will be
         */
        public function EdgeBuckets(vertexCount:int, edgeCount:int)
        {
            var count:int = 1 + edgeCount / EDGES_PER_BUCKET;
            _vertexCount = vertexCount;
            _bucketsPerVertex = count / vertexCount;
            _pairs = new Vector.<Array>(count, true);
            _edges = new Vector.<Array>(count, true);
            for (var i:int = 0; i < count; i++)
            {
                _pairs[i] = [];
                _edges[i] = [];
            }
        }

        /** How many buckets there are. */
        public function get length():int
        {
            return _pairs.length;
        }

        /**
         * Adds an edge.
         *
         * @param edge its number, not negative
         * @param from the number of the vertex where it begins
         * @param to that of the one where it ends, another one
         */
        public function add(edge:int, from:int, to:int):void
        {
            var low:int = from;
            var high:int = to;
            if (from > to)
            {
                low = to;
                high = from;
                edge = ~edge;
            }
            // the product is less than the number of buckets by more than it is rounded
            var bucket:int = low * _bucketsPerVertex;
            _pairs[bucket].push(low * _vertexCount + high);
            _edges[bucket].push(edge);
        }

        /** The number of an edge that may be inverted. */
        public static function numberOf(edge:int):int
        {
            return edge < 0 ? ~edge : edge;
        }

        /** For each edge of a bucket the number of its two vertices' pair. */
        public function pairsOf(bucket:int):Array
        {
            return _pairs[bucket];
        }

        /** Which edges a bucket has: their numbers, inverted (~) for those from the higher vertex to the lower. */
        public function edgesOf(bucket:int):Array
        {
            return _edges[bucket];
        }

        /** The places of a bucket's edges in an order in which those of a pair are side by side. */
        public function orderOf(bucket:int):Array
        {
            return _pairs[bucket].sort(Array.NUMERIC | Array.RETURNINDEXEDARRAY);
        }
    }
}
