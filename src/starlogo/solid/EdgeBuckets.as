package starlogo.solid
{
    /**
     * Sorts the edges of triangles into buckets, so that edges between the same two vertices are in the same bucket. The player's own sort
     * would bring these edges together fastest, but it sorts all edges in one call. It sorts a bucket in about a millisecond, unless very many
     * edges meet at a few vertices.
     */
    internal final class EdgeBuckets
    {
        private static const EDGES_PER_BUCKET:int = 3000;

        private var _vertexCount:Number;
        private var _bucketsPerVertex:Number;

        // For each bucket's edges, the number of the pair of vertices, and the edge's number. An edge from the higher vertex to the lower
        // has its number inverted (~).
        private var _pairs:Vector.<Array>;
        private var _edges:Vector.<Array>;

        /**
         * @param vertexCount the number of vertices
         * @param edgeCount the approximate number of edges
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

        /** The number of buckets. */
        public function get length():int
        {
            return _pairs.length;
        }

        /**
         * Adds an edge.
         *
         * @param edge its number, not negative
         * @param from the number of the vertex where it begins
         * @param to the number of the vertex where it ends; must differ from <code>from</code>
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
            // The product stays below the number of buckets in spite of rounding.
            var bucket:int = low * _bucketsPerVertex;
            _pairs[bucket].push(low * _vertexCount + high);
            _edges[bucket].push(edge);
        }

        /** The number of an edge that may be inverted. */
        public static function numberOf(edge:int):int
        {
            return edge < 0 ? ~edge : edge;
        }

        /** The pairs' numbers, for each edge of a bucket. */
        public function pairsOf(bucket:int):Array
        {
            return _pairs[bucket];
        }

        /** The edges of a bucket: their numbers, inverted (~) for edges from the higher vertex to the lower. */
        public function edgesOf(bucket:int):Array
        {
            return _edges[bucket];
        }

        /** The indices of a bucket's edges, ordered so that edges of the same pair are side by side. */
        public function orderOf(bucket:int):Array
        {
            return _pairs[bucket].sort(Array.NUMERIC | Array.RETURNINDEXEDARRAY);
        }
    }
}
