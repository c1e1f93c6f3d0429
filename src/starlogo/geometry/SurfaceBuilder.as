package starlogo.geometry
{
    import starlogo.steps.Steps;

    /**
     * Finds out what a model's triangles are as a whole, in steps. Vertices at the same place count as one, to within
     * Tolerances.WELDING. Costs sorting vertices and edges, and a few look-ups a triangle.
     *
     * @private
     */
    public final class SurfaceBuilder implements Steps
    {
        private static const TRIANGLES_A_STEP:int = 400;

        private static const WELDING:int = 0;
        private static const JOINING:int = 1;
        private static const NUMBERING:int = 2;
        private static const COMPARING:int = 3;
        private static const TURNING:int = 4;
        private static const BALANCING:int = 5;
        private static const DONE:int = 6;

        private var _surface:Surface = new Surface();
        private var _triangles:Vector.<uint>;
        private var _welding:Welding;
        private var _orientation:Orientation;
        private var _phase:int = WELDING;
        private var _next:int = 0;

        private var _hasArea:Boolean = false;

        // The vertices that hang together, then the number of the piece that a root stands for.
        private var _sets:DisjointSets;
        private var _numbers:Vector.<int>;

        // Three a triangle, of those that have an area.
        private var _edges:EdgeBuckets;

        /**
         * @param vertices x, y, z each
         * @param triangles three vertex indices each
         */
        public function SurfaceBuilder(vertices:Vector.<Number>, triangles:Vector.<uint>)
        {
            _triangles = triangles;
            _welding = new Welding(vertices);
            _orientation = new Orientation(vertices, triangles);
            var count:int = vertices.length / 3;
            _sets = new DisjointSets(count);
            _numbers = new Vector.<int>(count, true);
            for (var i:int = 0; i < count; i++)
            {
                _numbers[i] = -1;
            }
            _edges = new EdgeBuckets(count, triangles.length);
            _surface.pieces = new Vector.<int>(triangles.length / 3, true);
        }

        /** What was found, when no step is left. */
        public function get surface():Surface
        {
            return _surface;
        }

        /** @inheritDoc */
        public function step():Boolean
        {
            switch (_phase)
            {
                case WELDING:
                    if (!_welding.step())
                    {
                        _surface.widestSeam = _welding.widestGap;
                        _phase = JOINING;
                    }
                    break;
                case JOINING:
                    forSome(join, _surface.pieces.length);
                    break;
                case NUMBERING:
                    forSome(number, _surface.pieces.length);
                    break;
                case COMPARING:
                    compareBucket(null);
                    if (_next == _edges.length)
                    {
                        takeComparison();
                    }
                    break;
                case TURNING:
                    if (!_orientation.step())
                    {
                        takeOrientation();
                    }
                    break;
                case BALANCING:
                    compareBucket(_surface.isTurned);
                    if (_next == _edges.length)
                    {
                        _phase = DONE;
                    }
                    break;
            }
            return _phase != DONE;
        }

        private function forSome(work:Function, count:int):void
        {
            var end:int = Math.min(_next + TRIANGLES_A_STEP, count);
            for (var i:int = _next; i < end; i++)
            {
                work(i);
            }
            _next = end;
            if (end == count)
            {
                _phase++;
                _next = 0;
            }
        }

        private function join(triangle:int):void
        {
            var a:int = cornerOf(3 * triangle);
            var b:int = cornerOf(3 * triangle + 1);
            var c:int = cornerOf(3 * triangle + 2);
            _sets.join(a, b);
            _sets.join(a, c);
            if (a != b && b != c && c != a)
            {
                _hasArea = true;
                _edges.add(3 * triangle, a, b);
                _edges.add(3 * triangle + 1, b, c);
                _edges.add(3 * triangle + 2, c, a);
            }
        }

        private function number(triangle:int):void
        {
            var root:int = _sets.rootOf(cornerOf(3 * triangle));
            if (_numbers[root] < 0)
            {
                _numbers[root] = _surface.pieceCount++;
            }
            _surface.pieces[triangle] = _numbers[root];
        }

        // Whether the next bucket's edges between the same two vertices close the surface, and cancel out.
        private function compareBucket(isTurned:Vector.<Boolean>):void
        {
            var pairs:Array = _edges.pairsOf(_next);
            var edges:Array = _edges.edgesOf(_next);
            var order:Array = _edges.orderOf(_next++);
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
                _surface.isOriented &&= balance == 0;
                if (isTurned == null)
                {
                    takePair(edges, order, first, i, balance);
                }
            }
        }

        // Edges of the same two vertices, from one place in the order up to another.
        private function takePair(edges:Array, order:Array, first:int, end:int, balance:int):void
        {
            _surface.isClosed &&= (end - first) % 2 == 0;
            if (end - first == 2)
            {
                var a:int = EdgeBuckets.numberOf(edges[order[first]]);
                var b:int = EdgeBuckets.numberOf(edges[order[int(first + 1)]]);
                _orientation.connect(a, b, balance != 0);
            }
        }

        private function takeComparison():void
        {
            _surface.isClosed &&= _hasArea;
            _surface.isOriented &&= _surface.isClosed;
            _phase = _surface.isClosed && !_surface.isOriented ? TURNING : DONE;
        }

        private function takeOrientation():void
        {
            _surface.isTurned = _orientation.isTurned;
            _surface.isOriented = _orientation.isTurned != null;
            _phase = _surface.isOriented ? BALANCING : DONE;
            _next = 0;
        }

        private function cornerOf(index:int):int
        {
            return _welding.welded[_triangles[index]];
        }
    }
}
