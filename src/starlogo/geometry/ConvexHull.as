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
     * Finds the convex hull of vertices: its corners, edges, triangles and volume.
     *
     * <p>Each vertex is inside the hull, or outside by at most <code>Tolerances.HULL</code> of the vertices' extent. Flat sides have
     * vertices at their corners only. Vertices that span no volume are allowed. The hull is a polygon for vertices in a plane, two points
     * for vertices on a line, and one point for vertices in one place.</p>
     *
     * <p>The vertices are rounded to a grid of 2^25 steps along each of three axes. On this grid the hull is exact. In most cases these
     * are the coordinate axes. If the vertices are thin in another direction, the grid has axes along the vertices. The results are the
     * vertices themselves, not rounded.</p>
     *
     * <p>The cost is n log n for n vertices. The work can be done in steps, each of about one pass over the vertices.</p>
     */
    public final class ConvexHull implements Steps
    {
        private var _vertices:Vector.<Number>;
        private var _mesh:HullMesh;
        private var _convexPoints:Vector.<Number>;
        private var _grid:HullGrid = null;
        private var _volume:Number = NaN;

        // The current work.
        private var _work:StepSequence = new StepSequence();
        private var _simplex:InitialSimplex;
        private var _quickHull:QuickHull;

        /**
         * Computes the hull.
         *
         * @param vertices x, y, z of each vertex, in any unit; kept, not copied, and never changed
         * @param atOnce false leaves all work, including the check of the vertices, to <code>step()</code>. Until the last step, only the
         *     vertices may be read
         * @throws ArgumentError if the vertices are null or empty, if the number of coordinates is not a multiple of 3, or if a coordinate
         *     is not finite or beyond 1e60
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
         * @throws ArgumentError for the constructor's reasons, if it left the work to the steps
         */
        public function step():Boolean
        {
            return _work.step();
        }

        /** The vertices given to the constructor, x, y, z of each. Read only. */
        public function get vertices():Vector.<Number>
        {
            return _vertices;
        }

        /** 3 if the vertices span a volume, 2 if they are in a plane, 1 if they are on a line, 0 if they are in one place. */
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
         * Three perpendicular unit vectors, nine numbers. The first goes from one extreme vertex towards the vertex farthest from it. The
         * second is towards the vertex farthest from the line through both. For vertices in a plane, the third is the plane's normal.
         */
        public function get axes():Vector.<Number>
        {
            return _simplex.axes;
        }

        /** The hull's corners in ascending order, as indices of vertices. The first vertex has index 0. */
        public function get indices():Vector.<int>
        {
            return _mesh.indices;
        }

        /** The hull's corners, x, y, z of each, in the same order as <code>indices</code>. */
        public function get points():Vector.<Number>
        {
            return _mesh.points;
        }

        /**
         * The hull's corners on the grid, x, y, z of each, in the same order as <code>indices</code>. They are off their places by up to
         * <code>Tolerances.HULL</code> of the extent, but convex to the last digits. They are for walks along the hull's edges, because the
         * rounding of <code>points</code> would mislead a walk if edges are seen end on.
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
         * The hull's surface: three corners for each triangle, as positions in <code>indices</code>, counter-clockwise seen from outside.
         * Empty for vertices that span no volume.
         */
        public function get triangles():Vector.<int>
        {
            return _mesh.triangles;
        }

        /**
         * For each corner, the position in <code>neighbors</code> at which its neighbours begin. The neighbours of corner i are at
         * firstNeighbor[i] up to, but not including, firstNeighbor[i + 1]. So the list has one entry more than there are corners.
         */
        public function get firstNeighbor():Vector.<int>
        {
            return _mesh.firstNeighbor;
        }

        /** For each corner, the corners that share an edge with it, as positions in <code>indices</code>. */
        public function get neighbors():Vector.<int>
        {
            return _mesh.neighbors;
        }

        /** The volume of the hull, in cubic units; 0 without triangles. No convex shape around the vertices has a smaller volume. */
        public function get volume():Number
        {
            if (_volume != _volume)
            {
                _volume = measure();
            }
            return _volume;
        }

        /**
         * Finds the corner that is farthest in a direction, by climbing from neighbour to neighbour. If several corners are equally far,
         * the start decides which one is found. The number of steps is about the square root of the number of corners, and smaller if the
         * start is near. Allocates nothing.
         *
         * @param x of the direction, a vector of any length
         * @param y of the direction
         * @param z of the direction
         * @param from the corner to start from, as a position in <code>indices</code>
         * @param points the corners' places: null for <code>points</code>; otherwise <code>convexPoints</code>, or a rotation of one of the
         *     two
         * @return the corner, as a position in <code>indices</code>
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
                // Flat sides along the coordinate axes stay flat on a grid along these axes.
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

        // The index of the point above a plane's vertices.
        private function get apex():int
        {
            return _vertices.length / 3;
        }

        // The triangles between the apex and each edge of the outline of vertices in a plane. Each triangle is there twice, once for each
        // side.
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

        // The sum of the volumes of the tetrahedra from the first corner to each triangle.
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
