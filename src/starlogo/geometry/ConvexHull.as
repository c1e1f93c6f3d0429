package starlogo.geometry
{
    import starlogo.geometry.hull.HullGrid;
    import starlogo.geometry.hull.HullMesh;
    import starlogo.geometry.hull.InitialSimplex;
    import starlogo.geometry.hull.QuickHull;
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;
    import starlogo.steps.finish;

    /**
     * The convex hull of a set of vertices: its corners and how they are joined.
     *
     * <p>Every vertex given is inside the hull or at most <code>Tolerances.HULL</code> of the set's extent outside it;
     * flat sides have vertices at their corners only. Sets that span no volume are fine: a plane's hull is a polygon, a line's
     * two points, and that of a single point (repeated or not) the point.</p>
     *
     * <p>Vertices are rounded to a grid of 2^25 steps along each of three axes, the coordinate axes or, for sets that are thin
     * in some other direction, axes along the set; on the grid the hull is exact. What is handed out are the
     * vertices themselves, unrounded.</p>
     *
     * <p>Cost: n log n for n vertices. The work can be done in steps, each of about one pass over the vertices.</p>
     */
    public final class ConvexHull implements Steps
    {
        private var _vertices:Vector.<Number>;
        private var _mesh:HullMesh;
        private var _convexPoints:Vector.<Number>;
        private var _grid:HullGrid = null;
        private var _volume:Number = NaN;

        // the work under way
        private var _work:StepSequence = new StepSequence();
        private var _simplex:InitialSimplex;
        private var _quickHull:QuickHull;

        /**
         * Computes the hull.
         *
         * @param vertices x, y, z of each vertex, in any one unit; kept, not copied, and never changed
         * @param atOnce false leaves the work, including the check of the vertices, to <code>step()</code>: until no step is left, nothing but the
         *        vertices may be read
         * @throws ArgumentError if it is null or empty, has a length that is no multiple of 3, or holds a number that is not
         *         finite or beyond 1e100
         */
        public function ConvexHull(vertices:Vector.<Number>, atOnce:Boolean = true)
        {
            _vertices = vertices;
            _simplex = new InitialSimplex(vertices);
            _work.add(_simplex).begin(newGrid).begin(newHull).begin(newMesh);
            if (atOnce)
            {
                finish(this);
            }
        }

        /**
         * @inheritDoc
         *
         * @throws ArgumentError what the constructor throws, if it left the work to the steps
         */
        public function step():Boolean
        {
            return _work.step();
        }

        /** The vertices that it was made of, x, y, z each: read only. */
        public function get vertices():Vector.<Number>
        {
            return _vertices;
        }

        /** 3 for a set that spans a volume, 2 for one in a plane, 1 on a line, 0 in a point. */
        public function get dimension():int
        {
            return _simplex.dimension;
        }

        /** The longest side of the axis-aligned box around the vertices. */
        public function get extent():Number
        {
            return _simplex.extent;
        }

        /**
         * Three perpendicular unit vectors, nine numbers: the first from one extreme vertex towards the one farthest from
         * it, the second from there towards the vertex farthest from that line. A plane's third is its normal.
         */
        public function get axes():Vector.<Number>
        {
            return _simplex.axes;
        }

        /** The hull's corners in ascending order, as positions in <code>vertices</code> (0 is the first vertex). */
        public function get indices():Vector.<int>
        {
            return _mesh.indices;
        }

        /** The hull's corners, x, y, z each, in the same order as <code>indices</code>. */
        public function get points():Vector.<Number>
        {
            return _mesh.points;
        }

        /**
         * The hull's corners on the grid, x, y, z each, in the same order: off their places by up to
         * <code>Tolerances.HULL</code> of the extent, but convex to the last digits. For walks along the hull's edges, which the
         * rounding of coordinates would lead astray where edges are seen end on.
         */
        public function get convexPoints():Vector.<Number>
        {
            if (_convexPoints == null)
            {
                _convexPoints = _grid == null ? points : _grid.placesOf(indices);
            }
            return _convexPoints;
        }

        /**
         * The hull's surface: three corners a triangle, as positions in <code>indices</code>, counter-clockwise seen from
         * outside; empty for a set that spans no volume.
         */
        public function get triangles():Vector.<int>
        {
            return _mesh.triangles;
        }

        /**
         * Where each corner's neighbours begin in <code>neighbors</code>, one entry more than there are corners: those of
         * corner i are at firstNeighbor[i] up to, not including, firstNeighbor[i + 1].
         */
        public function get firstNeighbor():Vector.<int>
        {
            return _mesh.firstNeighbor;
        }

        /** The corners that an edge of the hull joins to each corner, as positions in <code>indices</code>. */
        public function get neighbors():Vector.<int>
        {
            return _mesh.neighbors;
        }

        /** What the hull encloses, in cubic units: no convex shape around the vertices is smaller. 0 without triangles. */
        public function get volume():Number
        {
            if (_volume != _volume)
            {
                _volume = measure();
            }
            return _volume;
        }

        /**
         * The corner that is farthest in a direction, found by climbing from neighbour to neighbour: of corners that are equally
         * far one, which depends on where the climb starts. About the square root of the number of corners in steps, fewer from
         * nearby; allocates nothing.
         *
         * @param x of the direction, a vector of any length
         * @param y of the direction
         * @param z of the direction
         * @param from the corner to start from, as a position in <code>indices</code>, like the result
         * @param points where the corners are: null for <code>points</code>; or <code>convexPoints</code>, or either of them turned
         */
        public function support(x:Number, y:Number, z:Number, from:int = 0, points:Vector.<Number> = null):int
        {
            var places:Vector.<Number> = points || _mesh.points;
            var first:Vector.<int> = _mesh.firstNeighbor;
            var joined:Vector.<int> = _mesh.neighbors;
            var corner:int = from;
            var at:int = 3 * corner;
            var best:Number = places[at] * x + places[at + 1] * y + places[at + 2] * z;
            do
            {
                from = corner;
                var end:int = first[from + 1];
                for (var i:int = first[from]; i < end; i++)
                {
                    var neighbor:int = joined[i];
                    at = 3 * neighbor;
                    var value:Number = places[at] * x + places[at + 1] * y + places[at + 2] * z;
                    if (value > best)
                    {
                        best = value;
                        corner = neighbor;
                    }
                }
            }
            while (corner != from);
            return corner;
        }

        private function newGrid():Steps
        {
            if (dimension > 1)
            {
                // along the coordinate axes, flat sides stay flat
                var gridAxes:Vector.<Number> = dimension == 2 || _simplex.isThin ? axes : new <Number>[1, 0, 0, 0, 1, 0, 0, 0, 1];
                _grid = new HullGrid(_vertices, gridAxes, dimension == 2);
            }
            return _grid;
        }

        private function newHull():Steps
        {
            if (dimension > 1)
            {
                var corners:Vector.<int> = _simplex.corners.concat();
                corners[3] = dimension == 2 ? apex : corners[3];
                _quickHull = new QuickHull(_grid.points, corners);
            }
            return _quickHull;
        }

        private function newMesh():Steps
        {
            var corners:Vector.<int> = _simplex.corners;
            switch (dimension)
            {
                case 3:
                    corners = _quickHull.triangles;
                    break;
                case 2:
                    corners = trianglesAtApex(_quickHull.triangles);
                    break;
                case 1:
                    corners = new <int>[corners[0], corners[1], apex, corners[1], corners[0], apex];
                    break;
                default:
                    corners = new <int>[corners[0], apex, apex];
            }
            _mesh = new HullMesh(_vertices, corners);
            _quickHull = null;
            return _mesh;
        }

        // The point above a plane's vertices.
        private function get apex():int
        {
            return _vertices.length / 3;
        }

        // Those triangles of a plane's hull that have an edge of the plane's outline, seen from both sides.
        private function trianglesAtApex(triangles:Vector.<int>):Vector.<int>
        {
            var found:Vector.<int> = new Vector.<int>();
            for (var i:int = 0; i < triangles.length; i++)
            {
                if (triangles[i] == apex)
                {
                    var first:int = i - i % 3;
                    var from:int = triangles[first + (i + 1) % 3];
                    var to:int = triangles[first + (i + 2) % 3];
                    found.push(from, to, apex, to, from, apex);
                }
            }
            return found;
        }

        // The sum of the tetrahedra from the first corner to each triangle.
        private function measure():Number
        {
            var places:Vector.<Number> = points;
            var corners:Vector.<int> = triangles;
            var fromX:Number = places[0];
            var fromY:Number = places[1];
            var fromZ:Number = places[2];
            var sum:Number = 0;
            for (var i:int = 0; i < corners.length; i += 3)
            {
                var a:int = 3 * corners[i];
                var b:int = 3 * corners[i + 1];
                var c:int = 3 * corners[i + 2];
                var bX:Number = places[b] - fromX;
                var bY:Number = places[b + 1] - fromY;
                var bZ:Number = places[b + 2] - fromZ;
                var cX:Number = places[c] - fromX;
                var cY:Number = places[c + 1] - fromY;
                var cZ:Number = places[c + 2] - fromZ;
                sum += (places[a] - fromX) * (bY * cZ - bZ * cY) + (places[a + 1] - fromY) * (bZ * cX - bX * cZ)
                    + (places[a + 2] - fromZ) * (bX * cY - bY * cX);
            }
            return sum / 6;
        }
    }
}
