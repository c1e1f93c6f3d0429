package starlogo.solid
{
    import starlogo.steps.StepSequence;

    /**
     * Computes a model's Surface, in steps: which vertices are at the same place, to within Tolerances.WELDING, which connected pieces the
     * triangles form, and in which directions the triangles run along each edge. It costs a sort of the vertices and edges, and a few
     * look-ups for each triangle.
     */
    internal final class SurfaceBuilder extends StepSequence
    {
        private static const TRIANGLES_PER_STEP:int = 400;

        /** The result. Complete after the last step. */
        public var surface:Surface;

        private var _triangles:Vector.<uint>;
        private var _welding:Welding;
        private var _hasArea:Boolean = false;

        // The connected vertices. For the representative of a set, one more than its piece's number, or 0.
        private var _sets:DisjointSets;
        private var _numbers:Vector.<int>;

        private var _orientation:Orientation;

        // Three edges for each triangle with an area.
        private var _edges:EdgeBuckets;
        private var _bucket:int = 0;

        /**
         * @param vertices x, y, z of each
         * @param triangles three vertex indices each
         */
        public function SurfaceBuilder(vertices:Vector.<Number>, triangles:Vector.<uint>)
        {
            var count:int = triangles.length / 3;
            surface = new Surface(count);
            _triangles = triangles;
            _welding = new Welding(vertices);
            _sets = new DisjointSets(vertices.length / 3);
            _numbers = new Vector.<int>(vertices.length / 3, true);
            _orientation = new Orientation(vertices, triangles);
            _edges = new EdgeBuckets(vertices.length / 3, triangles.length);
            add(_welding).slices(count, TRIANGLES_PER_STEP, joinSome).slices(count, TRIANGLES_PER_STEP, numberSome).repeat(compareSome).call(conclude);
        }

        private function joinSome(first:int, end:int):void
        {
            var welded:Vector.<int> = _welding.welded;
            var triangles:Vector.<uint> = _triangles;
            for (var i:int = first; i < end; i++)
            {
                var corner:int = 3 * i;
                var a:int = welded[triangles[corner]];
                var b:int = welded[triangles[int(corner + 1)]];
                var c:int = welded[triangles[int(corner + 2)]];
                _sets.join(a, b);
                _sets.join(a, c);
                if (a != b && b != c && c != a)
                {
                    _hasArea = true;
                    _edges.add(corner, a, b);
                    _edges.add(corner + 1, b, c);
                    _edges.add(corner + 2, c, a);
                }
            }
        }

        private function numberSome(first:int, end:int):void
        {
            surface.widestSeam = _welding.widestGap;
            for (var i:int = first; i < end; i++)
            {
                var root:int = _sets.rootOf(_welding.welded[_triangles[3 * i]]);
                if (_numbers[root] == 0)
                {
                    _numbers[root] = ++surface.partCount;
                }
                surface.parts[i] = _numbers[root] - 1;
            }
        }

        // Compares the edges of the next bucket: whether they close the surface, and whether they cancel.
        private function compareSome():Boolean
        {
            var isTurned:Vector.<Boolean> = surface.isTurned;
            var pairs:Array = _edges.pairsOf(_bucket);
            var edges:Array = _edges.edgesOf(_bucket);
            var order:Array = _edges.orderOf(_bucket++);
            var count:int = order.length;
            var i:int = 0;
            while (i < count)
            {
                var first:int = i;
                var pair:Number = pairs[order[i]];
                var balance:int = 0;
                while (i < count && pairs[order[i]] == pair)
                {
                    var edge:int = edges[order[i++]];
                    var isBackward:Boolean = edge < 0;
                    if (isTurned != null && isTurned[int(EdgeBuckets.numberOf(edge) / 3)])
                    {
                        isBackward = !isBackward;
                    }
                    balance += isBackward ? -1 : 1;
                }
                surface.isOriented &&= balance == 0;
                if (isTurned == null)
                {
                    compare(edges, order, first, i, balance);
                }
            }
            return _bucket < _edges.length;
        }

        // Compares the edges of one pair of vertices: a range in the order.
        private function compare(edges:Array, order:Array, first:int, end:int, balance:int):void
        {
            surface.isClosed &&= (end - first) % 2 == 0;
            if (end - first == 2)
            {
                var a:int = EdgeBuckets.numberOf(edges[order[first]]);
                var b:int = EdgeBuckets.numberOf(edges[order[int(first + 1)]]);
                _orientation.connect(a, b, balance != 0);
            }
        }

        private function conclude():void
        {
            surface.isClosed &&= _hasArea;
            surface.isOriented &&= surface.isClosed;
            if (surface.isClosed && !surface.isOriented)
            {
                add(_orientation).call(turn);
            }
        }

        // The edges are compared once more to find whether they cancel after triangles were reversed.
        private function turn():void
        {
            surface.isTurned = _orientation.isTurned;
            surface.isOriented = surface.isTurned != null;
            if (surface.isOriented)
            {
                _bucket = 0;
                repeat(compareSome);
            }
        }
    }
}
