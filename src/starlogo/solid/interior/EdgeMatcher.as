package starlogo.solid.interior
{
    import starlogo.data.zeroedInts;
    import starlogo.steps.StepSequence;

    /**
     * Pairs the triangles that continue each other over an edge, in steps. If two triangles share an edge, they are a pair. If more share it
     * (a non-manifold edge, for example where two boxes stand edge to edge), triangles that are connected elsewhere are paired first, then
     * triangles that run along the edge in opposite directions.
     *
     * <p>An edge has three times its triangle's index as its number, plus 0, 1 or 2. An edge is found by its lower vertex, and among the edges of
     * that vertex by its higher one. So no hash table is needed. The cost is linear, apart from sorting the edges at which more than two triangles
     * meet.</p>
     */
    internal final class EdgeMatcher extends StepSequence
    {
        private static const EDGES_PER_STEP:int = 3000;
        private static const TRIANGLES_PER_STEP:int = 1000;
        private static const VERTICES_PER_STEP:int = 1000;
        private static const NON_MANIFOLD_PER_STEP:int = 100;

        // How many waiting edges are tried for an edge: see matchSome().
        private static const MAX_TRIED:int = 8;

        // How lax a pass of matching is. It may match edges that run in opposite directions, of triangles with different third corners; opposite edges of
        // any triangles, so of copies of one too; or any edges.
        private static const STRICT:int = 0;
        private static const WITH_COPIES:int = 1;
        private static const ANY:int = 2;

        // In partners: no other edge is between the same two vertices; or more than one is, and the edge is not matched.
        private static const ALONE:int = -1;
        private static const NON_MANIFOLD:int = -2;

        /** For each edge, the edge that it is matched with; negative if there is none. Undefined for triangles without edges. Complete after the last step. */
        public var partners:Vector.<int>;

        private var _triangles:Vector.<uint>;
        private var _welder:VertexWelder;

        // For each vertex, one more than the last edge of which it is the lower vertex, or 0. For each edge, one more than the one before it with the same
        // lower vertex, or 0. Null after the edges are linked.
        private var _lastOfLow:Vector.<int>;
        private var _beforeOfLow:Vector.<int>;

        // For each vertex, one more than the last visited edge of which it is the higher vertex, or 0. Null after the edges are linked.
        private var _visitedOfHigh:Vector.<int>;

        // For each edge, the one before it between the same two vertices, or -1.
        private var _beforeBetweenSame:Vector.<int>;

        // If more than two edges are between the same two vertices, the last of these edges is in this list, in the order of the lower
        // vertices: the lower vertex times the number of edges, plus the edge. The sets have the triangles that are connected.
        private var _nonManifold:Array = [];
        private var _sets:DisjointSets;

        /**
         * @param triangles three vertex indices each
         * @param welder says which vertices are at the same place; read from the first step on
         */
        public function EdgeMatcher(triangles:Vector.<uint>, welder:VertexWelder)
        {
            _triangles = triangles;
            _welder = welder;
            var vertexCount:int = welder.welded.length;
            partners = zeroedInts(triangles.length);
            _beforeOfLow = zeroedInts(triangles.length);
            _beforeBetweenSame = zeroedInts(triangles.length);
            _lastOfLow = zeroedInts(vertexCount);
            _visitedOfHigh = zeroedInts(vertexCount);
            slices(triangles.length / 3, TRIANGLES_PER_STEP, listByLowVertex).slices(vertexCount, VERTICES_PER_STEP, matchEdges).call(beginNonManifold);
        }

        /** Whether a triangle has three different corners. Other triangles have no edges. */
        public function hasEdges(triangle:int):Boolean
        {
            var a:int = beginOf(3 * triangle);
            var b:int = beginOf(3 * triangle + 1);
            var c:int = beginOf(3 * triangle + 2);
            return a != b && b != c && c != a;
        }

        /** The vertex at which an edge begins. */
        public function beginOf(edge:int):int
        {
            return _welder.welded[_triangles[edge]];
        }

        private function endOf(edge:int):int
        {
            return beginOf(edge % 3 == 2 ? edge - 2 : edge + 1);
        }

        private function lowOf(edge:int):int
        {
            var begin:int = beginOf(edge);
            var end:int = endOf(edge);
            return begin < end ? begin : end;
        }

        // Gathers the edges of each lower vertex.
        private function listByLowVertex(first:int, end:int):void
        {
            for (var edge:int = 3 * first; edge < 3 * end; edge += 3)
            {
                var a:int = beginOf(edge);
                var b:int = beginOf(edge + 1);
                var c:int = beginOf(edge + 2);
                if (a != b && b != c && c != a)
                {
                    gatherAt(a < b ? a : b, edge);
                    gatherAt(b < c ? b : c, edge + 1);
                    gatherAt(c < a ? c : a, edge + 2);
                }
            }
        }

        private function gatherAt(low:int, edge:int):void
        {
            _beforeOfLow[edge] = _lastOfLow[low];
            _lastOfLow[low] = edge + 1;
        }

        // Links the edges between the same vertices, those of each lower vertex from the last one to the first. Two are matched. If there are more,
        // all of them wait.
        private function matchEdges(first:int, end:int):void
        {
            for (var low:int = first; low < end; low++)
            {
                for (var edge:int = _lastOfLow[low] - 1; edge >= 0; edge = _beforeOfLow[edge] - 1)
                {
                    var high:int = beginOf(edge) + endOf(edge) - low;
                    var later:int = _visitedOfHigh[high] - 1;
                    partners[edge] = ALONE;
                    _beforeBetweenSame[edge] = -1;
                    if (later >= 0 && lowOf(later) == low)
                    {
                        _beforeBetweenSame[later] = edge;
                        matchUnlessNonManifold(edge, later, low);
                    }
                    _visitedOfHigh[high] = edge + 1;
                }
            }
        }

        // Matches an edge with the later one between the same two vertices. If there are more than two, none of them is matched: all wait for
        // matchNonManifold().
        private function matchUnlessNonManifold(edge:int, later:int, low:int):void
        {
            var last:int = partners[later];
            if (last == ALONE)
            {
                match(edge, later);
                return;
            }
            partners[edge] = partners[later] = NON_MANIFOLD;
            if (last >= 0)
            {
                partners[last] = NON_MANIFOLD;
                _nonManifold.push(low * Number(partners.length) + last);
            }
        }

        private function match(a:int, b:int):void
        {
            partners[a] = b;
            partners[b] = a;
        }

        private function beginNonManifold():void
        {
            _lastOfLow = _beforeOfLow = _visitedOfHigh = null;
            _nonManifold.sort(Array.NUMERIC);
            if (_nonManifold.length > 0)
            {
                _sets = new DisjointSets(partners.length / 3);
                slices(partners.length, EDGES_PER_STEP, join).slices(_nonManifold.length, NON_MANIFOLD_PER_STEP, matchSomeNonManifold);
            }
        }

        private function join(first:int, end:int):void
        {
            for (var edge:int = first; edge < end; edge++)
            {
                if (partners[edge] > edge)
                {
                    _sets.join(edge / 3, partners[edge] / 3);
                }
            }
        }

        private function matchSomeNonManifold(first:int, end:int):void
        {
            for (var i:int = first; i < end; i++)
            {
                matchNonManifold(_nonManifold[i] % partners.length);
            }
        }

        // Edges of connected triangles are matched first, then the others in the order of the file. Copies of a triangle are matched later,
        // and edges that run in the same direction at last.
        private function matchNonManifold(last:int):void
        {
            var groups:Object = {};
            for (var edge:int = last; edge >= 0; edge = _beforeBetweenSame[edge])
            {
                var root:int = _sets.rootOf(edge / 3);
                groups[root] ||= [];
                groups[root].push(edge);
            }
            var rest:Array = [];
            // The order of the groups does not matter: each is matched alone, and rest is sorted.
            for each (var group:Array in groups)
            {
                group.reverse();
                for each (edge in matchSome(matchSome(group, STRICT), ANY))
                {
                    rest.push(edge);
                }
            }
            rest.sort(Array.NUMERIC);
            matchSome(matchSome(matchSome(rest, STRICT), WITH_COPIES), ANY);
        }

        // Matches each edge with the first waiting edge before it that a pass as lax as this may match with it. Only the first MAX_TRIED of the waiting
        // edges are tried, so the cost is linear. Returns the edges that are left.
        private function matchSome(edges:Array, laxity:int):Array
        {
            var waiting:Array = [];
            var next:int = 0;
            for each (var edge:int in edges)
            {
                var at:int = next;
                var end:int = Math.min(waiting.length, next + MAX_TRIED);
                while (at < end && neededLaxity(waiting[at], edge) > laxity)
                {
                    at++;
                }
                if (at == end)
                {
                    waiting.push(edge);
                    continue;
                }
                match(edge, waiting[at]);
                _sets.join(edge / 3, waiting[at] / 3);
                waiting[at] = waiting[next++];
            }
            return waiting.slice(next);
        }

        // How lax a pass has to be that may match two edges.
        private function neededLaxity(a:int, b:int):int
        {
            return beginOf(a) == beginOf(b) ? ANY : (thirdOf(a) == thirdOf(b) ? WITH_COPIES : STRICT);
        }

        // The corner of an edge's triangle that is not on the edge.
        private function thirdOf(edge:int):int
        {
            return beginOf(edge % 3 == 0 ? edge + 2 : edge - 1);
        }
    }
}
