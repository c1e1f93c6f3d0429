package starlogo.geometry
{
    import starlogo.steps.Steps;

    /**
     * Finds out what a model's triangles are as a whole, in steps. Vertices at the same place count as one, to within
     * Tolerances.WELDING. Costs two sorts and a few look-ups a triangle.
     *
     * @private
     */
    public final class SurfaceBuilder implements Steps
    {
        private static const TRIANGLES_A_STEP:int = 400;

        private static const WELDING:int = 0;
        private static const JOINING:int = 1;
        private static const NUMBERING:int = 2;
        private static const SORTING:int = 3;
        private static const COMPARING:int = 4;
        private static const TURNING:int = 5;
        private static const BALANCING:int = 6;
        private static const DONE:int = 7;

        private var _surface:Surface = new Surface();
        private var _triangles:Vector.<uint>;
        private var _welding:Welding;
        private var _orientation:Orientation;
        private var _phase:int = WELDING;
        private var _next:int = 0;

        // The vertices that hang together, then the number of the piece that a root stands for.
        private var _sets:DisjointSets;
        private var _numbers:Vector.<int>;

        // Three a triangle: twice the number of the two vertices' pair, and 1 more from the higher to the lower; -1 where the
        // triangle has no area. Equal pairs are side by side in the order.
        private var _edges:Array;
        private var _sort:SteppedSort = null;
        private var _order:Array;

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
            _edges = new Array(triangles.length);
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
                case SORTING:
                    sortSome();
                    break;
                case COMPARING:
                    compareSome();
                    break;
                case TURNING:
                    if (!_orientation.step())
                    {
                        takeOrientation();
                    }
                    break;
                case BALANCING:
                    balanceSome();
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
            var hasArea:Boolean = a != b && b != c && c != a;
            _edges[3 * triangle] = hasArea ? edge(a, b) : -1;
            _edges[3 * triangle + 1] = hasArea ? edge(b, c) : -1;
            _edges[3 * triangle + 2] = hasArea ? edge(c, a) : -1;
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

        // As numbers, so that the native sort brings those of the same two vertices together.
        private function sortSome():void
        {
            _sort ||= new SteppedSort(_edges);
            if (!_sort.step())
            {
                _order = _sort.order;
                _sort = null;
                _surface.isClosed = _order.length > 0 && _edges[_order[_order.length - 1]] >= 0;
                _phase = COMPARING;
            }
        }

        private function compareSome():void
        {
            var last:int = Math.min(_next + 3 * TRIANGLES_A_STEP, _order.length);
            while (_next < last)
            {
                var first:int = _next;
                var pair:Number = Math.floor(_edges[_order[first]] / 2);
                var balance:int = 0;
                while (_next < _order.length && Math.floor(_edges[_order[_next]] / 2) == pair)
                {
                    balance += _edges[_order[_next]] == 2 * pair ? 1 : -1;
                    _next++;
                }
                if (pair >= 0)
                {
                    _surface.isOriented &&= balance == 0;
                    _surface.isClosed &&= (_next - first) % 2 == 0;
                    if (_next - first == 2)
                    {
                        _orientation.connect(_order[first], _order[first + 1], balance != 0);
                    }
                }
            }
            if (_next == _order.length)
            {
                _surface.isOriented &&= _surface.isClosed;
                _phase = _surface.isClosed && !_surface.isOriented ? TURNING : DONE;
            }
        }

        private function takeOrientation():void
        {
            _surface.isTurned = _orientation.isTurned;
            _surface.isOriented = _orientation.isTurned != null;
            _phase = _surface.isOriented ? BALANCING : DONE;
            _next = 0;
        }

        // Whether the edges between the same two vertices cancel out, now that triangles are turned.
        private function balanceSome():void
        {
            var last:int = Math.min(_next + 3 * TRIANGLES_A_STEP, _order.length);
            while (_next < last)
            {
                var pair:Number = Math.floor(_edges[_order[_next]] / 2);
                var balance:int = 0;
                while (_next < _order.length && Math.floor(_edges[_order[_next]] / 2) == pair)
                {
                    var index:int = _order[_next];
                    balance += (_edges[index] == 2 * pair) != _surface.isTurned[int(index / 3)] ? 1 : -1;
                    _next++;
                }
                if (pair >= 0 && balance != 0)
                {
                    _surface.isOriented = false;
                    last = _next = _order.length;
                }
            }
            if (_next == _order.length)
            {
                _phase = DONE;
            }
        }

        private function cornerOf(index:int):int
        {
            return _welding.welded[_triangles[index]];
        }

        private function edge(from:int, to:int):Number
        {
            var count:Number = _numbers.length;
            return from < to ? 2 * (from * count + to) : 2 * (to * count + from) + 1;
        }
    }
}
