package starlogo.geometry.hull
{
    import starlogo.geometry.Tolerances;
    import starlogo.geometry.vertices.VertexBounds;
    import starlogo.geometry.vertices.vertexProblem;
    import starlogo.steps.StepSequence;

    /**
     * Finds up to four vertices that are far from each other, the number of dimensions that they span, and axes along them. If they span
     * fewer than three dimensions, all other vertices lie in the same plane, line or place, up to the flatness.
     * Each of the four takes a pass over the vertices, in steps.
     *
     * @private
     */
    public final class InitialSimplex extends StepSequence
    {
        private static const VERTICES_PER_STEP:int = 4000;

        /** The axis-aligned box around the vertices. All results are complete after the last step. */
        public var bounds:VertexBounds = new VertexBounds();

        /** 3 if the vertices span a volume, 2 if they are in a plane, 1 if they are on a line, 0 if they are in one place. */
        public var dimension:int = 0;

        /** Three perpendicular unit vectors: see ConvexHull. */
        public var axes:Vector.<Number> = new <Number>[1, 0, 0, 0, 1, 0, 0, 0, 1];

        /** The vertices, x, y, z of each. */
        public var vertices:Vector.<Number>;

        /** The indices of the vertices found. Their number is at least <code>dimension</code> plus 1. */
        public var corners:Vector.<int> = new Vector.<int>();

        private var _origin:Number;

        // The vertex that is farthest from the space spanned so far, and the square of its distance.
        private var _farthest:int;
        private var _greatestSquare:Number;

        /**
         * @param vertices x, y, z of each. The steps throw an ArgumentError if they are null or empty, if the number of coordinates is not
         *     a multiple of 3, or if a coordinate is not finite or beyond 1e60
         * @param origin the largest absolute coordinate of the place from which the vertices are measured
         */
        public function InitialSimplex(vertices:Vector.<Number>, origin:Number)
        {
            this.vertices = vertices;
            _origin = origin;
            call(measure);
        }

        /** The distance up to which a vertex counts as in a plane, a line or a place. */
        public function get flatness():Number
        {
            return Tolerances.HULL_FLAT * bounds.extent + Tolerances.HULL_ROUNDING * (_origin + bounds.largest);
        }

        /**
         * Whether vertices of three dimensions are thin in a direction between the coordinate axes. A grid along the coordinate axes would
         * lose precision then.
         */
        public function get isSlanted():Boolean
        {
            var spanned:Number = 1;
            for (var i:int = 0; i < 3; i++)
            {
                spanned *= Math.abs(along(i, corners[i + 1]) - along(i, corners[0]));
            }
            return spanned < Tolerances.HULL_THIN * (bounds.extentX * bounds.extentY * bounds.extentZ);
        }

        private function measure():void
        {
            if (vertices == null || vertices.length == 0 || vertices.length % 3 != 0)
            {
                throw new ArgumentError(vertexProblem(vertices));
            }
            slices(vertices.length / 3, VERTICES_PER_STEP, function(first:int, end:int):void
                {
                    bounds.add(vertices, first, end);
                }).call(checkBounds).call(findCorner);
        }

        private function checkBounds():void
        {
            if (!bounds.areFinite)
            {
                throw new ArgumentError(vertexProblem(vertices));
            }
            VertexBounds.requireWithin(bounds.largest);
        }

        // Adds the steps that find the next corner.
        private function findCorner():void
        {
            _greatestSquare = -1;
            slices(vertices.length / 3, VERTICES_PER_STEP, findFarthest).call(addCorner);
        }

        private function addCorner():void
        {
            corners.push(_farthest);
            if ((corners.length == 1 || addDimension()) && dimension < 3)
            {
                findCorner();
            }
        }

        // Finds the vertex that is farthest: first from the box's middle, then from the first corner, then from the line, then from the
        // plane.
        private function findFarthest(first:int, end:int):void
        {
            var given:Vector.<Number> = vertices;
            var fromX:Number = (bounds.minX + bounds.maxX) / 2;
            var fromY:Number = (bounds.minY + bounds.maxY) / 2;
            var fromZ:Number = (bounds.minZ + bounds.maxZ) / 2;
            if (corners.length > 0)
            {
                fromX = given[3 * corners[0]];
                fromY = given[3 * corners[0] + 1];
                fromZ = given[3 * corners[0] + 2];
            }
            var found:Vector.<Number> = axes;
            for (var i:int = 3 * first; i < 3 * end; i += 3)
            {
                var x:Number = given[i] - fromX;
                var y:Number = given[int(i + 1)] - fromY;
                var z:Number = given[int(i + 2)] - fromZ;
                var square:Number = 0;
                // only distances perpendicular to the axes found so far count
                for (var k:int = 3 * dimension; k < 9; k += 3)
                {
                    var along:Number = x * found[k] + y * found[int(k + 1)] + z * found[int(k + 2)];
                    square += along * along;
                }
                if (square > _greatestSquare)
                {
                    _greatestSquare = square;
                    _farthest = i / 3;
                }
            }
        }

        // If the farthest vertex is outside of the space spanned so far, gives the space one more dimension, and an axis towards the vertex.
        // Returns whether it is.
        private function addDimension():Boolean
        {
            var from:int = 3 * corners[0];
            var x:Number = vertices[3 * _farthest] - vertices[from];
            var y:Number = vertices[3 * _farthest + 1] - vertices[from + 1];
            var z:Number = vertices[3 * _farthest + 2] - vertices[from + 2];
            // This is done twice, because the rounding left along the axes matters if the vertex is close to them.
            for (var i:int = 0; i < 2 * dimension; i++)
            {
                var axis:int = 3 * (i % dimension);
                var t:Number = x * axes[axis] + y * axes[axis + 1] + z * axes[axis + 2];
                x -= t * axes[axis];
                y -= t * axes[axis + 1];
                z -= t * axes[axis + 2];
            }
            if (!(Math.sqrt(x * x + y * y + z * z) > flatness))
            {
                return false;
            }
            if (dimension < 2)
            {
                setAxis(dimension, x, y, z);
            }
            if (dimension == 0)
            {
                // The coordinate axis that is farthest from the first axis.
                var isX:Boolean = Math.abs(x) <= Math.abs(y) && Math.abs(x) <= Math.abs(z);
                var isY:Boolean = !isX && Math.abs(y) <= Math.abs(z);
                setAxisAcross(1, isX ? 1 : 0, isY ? 1 : 0, isX || isY ? 0 : 1);
            }
            setAxisAcross(2, axes[3], axes[4], axes[5]);
            dimension++;
            return true;
        }

        // Sets an axis perpendicular to the first one and to a vector.
        private function setAxisAcross(axis:int, x:Number, y:Number, z:Number):void
        {
            setAxis(axis, axes[1] * z - axes[2] * y, axes[2] * x - axes[0] * z, axes[0] * y - axes[1] * x);
        }

        private function along(axis:int, vertex:int):Number
        {
            return vertices[3 * vertex] * axes[3 * axis] + vertices[3 * vertex + 1] * axes[3 * axis + 1]
                + vertices[3 * vertex + 2] * axes[3 * axis + 2];
        }

        private function setAxis(axis:int, x:Number, y:Number, z:Number):void
        {
            var length:Number = Math.sqrt(x * x + y * y + z * z);
            axes[3 * axis] = x / length;
            axes[3 * axis + 1] = y / length;
            axes[3 * axis + 2] = z / length;
        }
    }
}
