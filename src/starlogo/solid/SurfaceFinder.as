package starlogo.solid
{
    import starlogo.steps.StepSequence;

    /**
     * What a SurfaceBuilder and a SurfaceCheck have in common: finds in steps which vertices are at the same place, to within
     * Tolerances.WELDING, and which pieces the triangles hang together in; hands the triangles that have an area on to a subclass.
     */
    internal class SurfaceFinder extends StepSequence
    {
        /** The surface as far as it is known. */
        protected var found:Surface = new Surface();

        /** Whether a triangle has an area. */
        protected var hasArea:Boolean = false;

        private var _triangles:Vector.<uint>;
        private var _welding:Welding;

        // The vertices that hang together; for the root of a set, 1 more than the number of its piece, or 0.
        private var _sets:DisjointSets;
        private var _numbers:Vector.<int>;

        /**
         * @param vertices x, y, z each
         * @param triangles three vertex indices each
         * @param trianglesPerStep how many a step looks at
         */
        public function SurfaceFinder(vertices:Vector.<Number>, triangles:Vector.<uint>, trianglesPerStep:int)
        {
            var count:int = triangles.length / 3;
            _triangles = triangles;
            _welding = new Welding(vertices);
            _sets = new DisjointSets(vertices.length / 3);
            _numbers = new Vector.<int>(vertices.length / 3, true);
            found.pieces = new Vector.<int>(count, true);
            add(_welding).slices(count, trianglesPerStep, joinSome).slices(count, trianglesPerStep, numberSome);
        }

        /** What was found, when no step is left; null if what was known does not hold. */
        public function get surface():Surface
        {
            return found;
        }

        /** Takes a triangle whose corners are at three places: the numbers of the vertices that all others there are welded to. */
        protected function addTriangle(triangle:int, a:int, b:int, c:int):void
        {
        }

        /** Takes the number of the piece that a triangle is of. */
        protected function addToPiece(triangle:int, piece:int):void
        {
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
                    hasArea = true;
                    addTriangle(i, a, b, c);
                }
            }
        }

        private function numberSome(first:int, end:int):void
        {
            found.widestSeam = _welding.widestGap;
            for (var i:int = first; i < end; i++)
            {
                var root:int = _sets.rootOf(_welding.welded[_triangles[3 * i]]);
                if (_numbers[root] == 0)
                {
                    _numbers[root] = ++found.pieceCount;
                }
                found.pieces[i] = _numbers[root] - 1;
                addToPiece(i, found.pieces[i]);
            }
        }
    }
}
