package starlogo.geometry
{
    import starlogo.steps.Steps;

    /**
     * Finds out in steps what a SurfaceBuilder does, several times as fast, where it is known which triangles must be turned round.
     *
     * <p>What is known is not believed. Whether edges cancel out needs no pairing of them: every pair of vertices has a number that
     * looks random; along a surface that closes the exclusive or of all edges' numbers is 0, and along one that is oriented
     * the sum of those in one direction less those in the other. A surface of another kind passes once in four billion.</p>
     *
     * @private
     */
    public final class SurfaceCheck implements Steps
    {
        private static const VERTICES_A_STEP:int = 3000;
        private static const TRIANGLES_A_STEP:int = 1000;

        private static const WELDING:int = 0;
        private static const MARKING:int = 1;
        private static const JOINING:int = 2;
        private static const NUMBERING:int = 3;
        private static const DONE:int = 4;

        private var _surface:Surface = new Surface();
        private var _triangles:Vector.<uint>;
        private var _isTurned:Vector.<Boolean>;
        private var _welding:Welding;
        private var _phase:int = WELDING;
        private var _next:int = 0;

        // The vertices that hang together, then the number of the piece that a root stands for; the vertices' random numbers.
        private var _sets:DisjointSets;
        private var _numbers:Vector.<int>;
        private var _marks:Vector.<int>;
        private var _mark:int = 0x2545F491;

        private var _hasArea:Boolean = false;
        private var _parity:int = 0;
        private var _balance:int = 0;
        private var _turnedBalance:int = 0;

        // Of each piece how many triangles it has, less twice those that are turned.
        private var _majorities:Vector.<int> = new Vector.<int>();

        /**
         * @param vertices x, y, z each
         * @param triangles three vertex indices each
         * @param isTurned for each triangle, whether it must be turned round, as a SurfaceBuilder found it; null if none must
         */
        public function SurfaceCheck(vertices:Vector.<Number>, triangles:Vector.<uint>, isTurned:Vector.<Boolean>)
        {
            _triangles = triangles;
            _isTurned = isTurned;
            _welding = new Welding(vertices);
            var count:int = vertices.length / 3;
            _sets = new DisjointSets(count);
            _numbers = new Vector.<int>(count, true);
            _marks = new Vector.<int>(count, true);
            _surface.pieces = new Vector.<int>(triangles.length / 3, true);
        }

        /** What was found, when no step is left; null if what was known does not hold. */
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
                        _phase = MARKING;
                    }
                    break;
                case MARKING:
                    markSome();
                    break;
                case JOINING:
                    joinSome();
                    break;
                case NUMBERING:
                    numberSome();
                    break;
            }
            return _phase != DONE;
        }

        // Marsaglia, "Xorshift RNGs", Journal of Statistical Software 8(14), 2003.
        private function markSome():void
        {
            var end:int = Math.min(_next + VERTICES_A_STEP, _numbers.length);
            for (var i:int = _next; i < end; i++)
            {
                _mark ^= _mark << 13;
                _mark ^= _mark >>> 17;
                _mark ^= _mark << 5;
                _marks[i] = _mark;
                _numbers[i] = -1;
            }
            _next = end;
            if (end == _numbers.length)
            {
                _phase = JOINING;
                _next = 0;
            }
        }

        private function joinSome():void
        {
            var welded:Vector.<int> = _welding.welded;
            var triangles:Vector.<uint> = _triangles;
            var count:int = triangles.length / 3;
            var end:int = Math.min(_next + TRIANGLES_A_STEP, count);
            for (var i:int = _next; i < end; i++)
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
                    addEdges(a, b, c, _isTurned != null && _isTurned[i]);
                }
            }
            _next = end;
            if (end == count)
            {
                _phase = NUMBERING;
                _next = 0;
            }
        }

        private function addEdges(a:int, b:int, c:int, isTurned:Boolean):void
        {
            var first:int = numberOf(_marks[a] ^ _marks[b]);
            var second:int = numberOf(_marks[b] ^ _marks[c]);
            var third:int = numberOf(_marks[c] ^ _marks[a]);
            _parity ^= first ^ second ^ third;
            var sum:int = a < b ? first : -first;
            sum += b < c ? second : -second;
            sum += c < a ? third : -third;
            _balance += sum;
            _turnedBalance += isTurned ? -sum : sum;
        }

        // Jenkins's one-at-a-time hash's last lines, twice.
        private static function numberOf(both:int):int
        {
            both += both << 10;
            both ^= both >>> 6;
            both += both << 3;
            both ^= both >>> 11;
            both += both << 15;
            both ^= both >>> 7;
            return both;
        }

        private function numberSome():void
        {
            var count:int = _triangles.length / 3;
            var end:int = Math.min(_next + TRIANGLES_A_STEP, count);
            for (var i:int = _next; i < end; i++)
            {
                var root:int = _sets.rootOf(_welding.welded[_triangles[3 * i]]);
                if (_numbers[root] < 0)
                {
                    _numbers[root] = _surface.pieceCount++;
                    _majorities.push(0);
                }
                var piece:int = _numbers[root];
                _surface.pieces[i] = piece;
                _majorities[piece] += _isTurned != null && _isTurned[i] ? -1 : 1;
            }
            _next = end;
            if (end == count)
            {
                conclude();
                _phase = DONE;
            }
        }

        private function conclude():void
        {
            _surface.isClosed = _hasArea && _parity == 0;
            _surface.isOriented = _surface.isClosed && _balance == 0;
            var mustTurn:Boolean = _surface.isClosed && _balance != 0;
            if (!mustTurn && _isTurned == null)
            {
                return;
            }
            if (mustTurn && _isTurned != null && _turnedBalance == 0 && areFewTurned())
            {
                _surface.isOriented = true;
                _surface.isTurned = _isTurned;
                return;
            }
            _surface = null;
        }

        // A piece keeps the side that most of its triangles have for the front.
        private function areFewTurned():Boolean
        {
            for each (var majority:int in _majorities)
            {
                if (majority < 0)
                {
                    return false;
                }
            }
            return true;
        }
    }
}
