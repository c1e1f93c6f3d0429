package starlogo.geometry.hull
{
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.geometry.placePoints;
    import starlogo.geometry.vertices.VertexBounds;
    import starlogo.steps.finish;
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;

    use namespace engine;

    /**
     * Finds the convex hull of vertices: its corners, triangles and volume.
     *
     * <p>Each vertex is inside the hull, or outside by at most 2e-7 of the vertices' extent. Flat sides have vertices at their corners only, and
     * seldom one that rounding puts outside of an edge. Vertices that span no volume are allowed. The hull is a polygon for vertices in a plane, two
     * points for vertices on a line, and one point for vertices in one place.</p>
     *
     * <p>The vertices are rounded to a grid of 2^25 steps along each of three axes. On this grid the hull is convex without rounding, but vertices
     * that are less than two steps above a triangle of it, and not more beside it, are left out. In most cases the axes are the coordinate axes. If the
     * vertices are thin in another direction, the grid has axes along the vertices. The results are the vertices themselves, not rounded. They are
     * complete after the last step. Read only.</p>
     *
     * <p>The cost is n log n for n vertices. The work can be done in steps, each of about one pass over the vertices.</p>
     */
    public final class ConvexHull implements Steps
    {
        private static const VERTICES_PER_STEP:int = 2000;

        /** The hull's corners in ascending order, as indices of vertices. The first vertex has index 0. */
        public var indices:Vector.<int> = new Vector.<int>();

        /** The hull's corners, x, y, z of each, in the same order as <code>indices</code>. */
        public var points:Vector.<Number> = new Vector.<Number>();

        /**
         * The hull's surface: three corners for each triangle, as positions in <code>indices</code>, counter-clockwise seen from outside.
         * Empty for vertices that span no volume.
         */
        public var triangles:Vector.<int> = new Vector.<int>();

        /**
         * The corners of vertices in a plane in their order around it, as positions in <code>indices</code>: counter-clockwise seen from the side
         * to which the third of the <code>axes</code> points. Empty for vertices that span another number of dimensions.
         */
        public var outline:Vector.<int> = new Vector.<int>();

        private var _work:StepSequence = new StepSequence();
        private var _simplex:InitialSimplex;

        /**
         * Computes the hull.
         *
         * @param vertices x, y, z of each vertex, in any unit. An extent below 1e-150 counts as none. The list is kept, not copied, and never changed
         * @param atOnce false leaves all work, including the check of the vertices, to <code>step()</code>. Until the last step, only the
         *     vertices may be read
         * @param origin the largest absolute coordinate of the place from which the vertices are measured. They may be beside a plane, a line or a
         *     place by the rounding there, and count as in it
         * @throws ArgumentError if the vertices are null or empty, if the number of coordinates is not a multiple of 3, or if a coordinate
         *     is not finite or beyond 1e60
         */
        public function ConvexHull(vertices:Vector.<Number>, atOnce:Boolean = true, origin:Number = 0)
        {
            _simplex = new InitialSimplex(vertices, origin);
            _work.add(_simplex).begin(building);
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
            return _simplex.vertices;
        }

        /** 3 if the vertices span a volume, 2 if they are in a plane, 1 if they are on a line, 0 if they are in one place. */
        public function get dimension():int
        {
            return _simplex.dimension;
        }

        /** The longest side of the axis-aligned box around the vertices. */
        public function get extent():Number
        {
            return _simplex.bounds.extent;
        }

        /** The distance up to which a vertex counts as in a plane, a line or a place. */
        public function get flatness():Number
        {
            return _simplex.flatness;
        }

        /**
         * Three perpendicular unit vectors, nine numbers. The first goes from one extreme vertex towards the vertex farthest from it. The
         * second is towards the vertex farthest from the line through both. For vertices in a plane, the third is the plane's normal.
         */
        public function get axes():Vector.<Number>
        {
            return _simplex.axes;
        }

        /** The volume of the hull, in cubic units; 0 without triangles. No convex shape around the vertices has a smaller volume. */
        public function get volume():Number
        {
            return volumeInside(points, triangles);
        }

        /**
         * The volume inside of a closed surface: the sum of the tetrahedra from its first corner to each triangle.
         *
         * @param points x, y, z of each corner
         * @param triangles three corners each, counter-clockwise seen from outside
         * @private
         */
        engine static function volumeInside(points:Vector.<Number>, triangles:Vector.<int>):Number
        {
            var sum:Number = 0;
            var fromX:Number = points[0];
            var fromY:Number = points[1];
            var fromZ:Number = points[2];
            for (var i:int = 0; i < triangles.length; i += 3)
            {
                var a:int = 3 * triangles[i];
                var b:int = 3 * triangles[i + 1];
                var c:int = 3 * triangles[i + 2];
                var bX:Number = points[b] - fromX;
                var bY:Number = points[b + 1] - fromY;
                var bZ:Number = points[b + 2] - fromZ;
                var cX:Number = points[c] - fromX;
                var cY:Number = points[c + 1] - fromY;
                var cZ:Number = points[c + 2] - fromZ;
                sum += (points[a] - fromX) * (bY * cZ - bZ * cY) + (points[a + 1] - fromY) * (bZ * cX - bX * cZ)
                    + (points[a + 2] - fromZ) * (bX * cY - bY * cX);
            }
            // the volume of a needle is a rounding error, which may be negative
            return sum > 0 ? sum / 6 : 0;
        }

        // The steps that build the hull of vertices on a grid, and number its corners. Vertices in a plane get an extra point outside, the apex.
        private function building():Steps
        {
            var simplex:Vector.<int> = _simplex.corners.concat();
            if (dimension < 2)
            {
                number(simplex.slice(0, dimension + 1));
                return null;
            }
            var grid:Vector.<Number> = new Vector.<Number>(vertices.length);
            simplex[3] = dimension == 2 ? apex : simplex[3];
            return snapping(grid).begin(function():Steps
                {
                    var hull:QuickHull = new QuickHull(grid, simplex);
                    return new StepSequence().add(hull).call(function():void
                        {
                            number(dimension == 3 ? hull.triangles : outlineFrom(hull.triangles));
                        });
                });
        }

        // The steps that write the vertices on the grid: whole numbers from 0 to QuickHull.GRID. Vertices in a plane are on the grid's floor.
        private function snapping(grid:Vector.<Number>):StepSequence
        {
            var work:StepSequence = new StepSequence();
            var isPlane:Boolean = dimension == 2;
            var given:Vector.<Number> = _simplex.vertices;
            var count:int = given.length / 3;
            var from:Vector.<Number> = given;
            var bounds:VertexBounds = _simplex.bounds;
            if (isPlane)
            {
                grid.push(QuickHull.GRID / 2, QuickHull.GRID / 2, QuickHull.GRID);
            }
            // Flat sides along the coordinate axes stay flat on a grid along these axes.
            if (isPlane || _simplex.isSlanted)
            {
                var rotation:Placement = new Placement();
                rotation.setRows(axes, 0);
                bounds = new VertexBounds();
                from = grid;
                work.slices(count, VERTICES_PER_STEP, function(first:int, end:int):void
                    {
                        placePoints(rotation, given, 3 * first, 3 * end, grid, 3 * first);
                        bounds.add(grid, first, end);
                    });
            }
            return work.slices(count, VERTICES_PER_STEP, function(first:int, end:int):void
                {
                    snap(from, 3 * first, 3 * end, bounds.minX, QuickHull.GRID / bounds.extentX, grid);
                    snap(from, 3 * first + 1, 3 * end, bounds.minY, QuickHull.GRID / bounds.extentY, grid);
                    snap(from, 3 * first + 2, 3 * end, bounds.minZ, isPlane ? 0 : QuickHull.GRID / bounds.extentZ, grid);
                });
        }

        // Rounds every third of the numbers from one index up to another, in steps of the grid from the least of them.
        private static function snap(from:Vector.<Number>, first:int, end:int, low:Number, scale:Number, grid:Vector.<Number>):void
        {
            for (var i:int = first; i < end; i += 3)
            {
                grid[i] = int((from[i] - low) * scale + 0.5);
            }
        }

        // Numbers the corners. It replaces the indices of vertices in the list by positions among the hull's corners.
        // @param corners the triangles' corners, or those of the outline, or all of a line or a place
        private function number(corners:Vector.<int>):void
        {
            var given:Vector.<Number> = _simplex.vertices;
            var count:int = given.length / 3;
            var positions:Vector.<int> = new Vector.<int>(count);
            for each (var corner:int in corners)
            {
                positions[corner] = 1;
            }
            for (var i:int = 0; i < count; i++)
            {
                if (positions[i] == 1)
                {
                    positions[i] = indices.length;
                    indices.push(i);
                    points.push(given[3 * i], given[3 * i + 1], given[3 * i + 2]);
                }
            }
            for (i = 0; i < corners.length; i++)
            {
                corners[i] = positions[corners[i]];
            }
            triangles = dimension == 3 ? corners : triangles;
            outline = dimension == 2 ? corners : outline;
        }

        // The index of the point above a plane's vertices.
        private function get apex():int
        {
            return vertices.length / 3;
        }

        // The outline of vertices in a plane, as indices of vertices: the edges across from the apex in its triangles.
        private function outlineFrom(ofPyramid:Vector.<int>):Vector.<int>
        {
            var next:Vector.<int> = new Vector.<int>(apex);
            var start:int;
            for (var i:int = 0; i < ofPyramid.length; i++)
            {
                if (ofPyramid[i] == apex)
                {
                    var first:int = i - i % 3;
                    start = ofPyramid[first + (i + 1) % 3];
                    next[start] = ofPyramid[first + (i + 2) % 3];
                }
            }
            var found:Vector.<int> = new <int>[start];
            for (var at:int = next[start]; at != start; at = next[at])
            {
                found.push(at);
            }
            return found;
        }
    }
}
