package starlogo.geometry.hull
{
    import starlogo.geometry.Tolerances;
    import starlogo.geometry.VertexBounds;
    import starlogo.geometry.VertexData;
    import starlogo.steps.StepSequence;

    /**
     * Up to four vertices of a set that are far from each other, how many dimensions they span, and axes along them. Every
     * other vertex lies in the point, on the line or in the plane of fewer than four, up to Tolerances.HULL_FLAT and
     * HULL_ROUNDING. Each takes a pass over the vertices, in steps.
     *
     * @private
     */
    public final class InitialSimplex extends StepSequence
    {
        private static const VERTICES_PER_STEP:int = 4000;

        /** The longest side of the axis-aligned box around the vertices; this and all others when no step is left. */
        public var extent:Number = 0;

        /** 3 for a set that spans a volume, 2 for one in a plane, 1 on a line, 0 in a point. */
        public var dimension:int = 0;

        /** Three perpendicular unit vectors: see ConvexHull. */
        public var axes:Vector.<Number> = new <Number>[1, 0, 0, 0, 1, 0, 0, 0, 1];

        /** The vertices, by their numbers: at least one more than dimensions. */
        public var corners:Vector.<int> = new Vector.<int>();

        private var _vertices:Vector.<Number>;
        private var _bounds:VertexBounds = new VertexBounds();
        private var _flat:Number;

        // the vertex that is farthest from what is spanned so far, and the square of its distance
        private var _farthest:int;
        private var _most:Number;

        /**
         * @param vertices x, y, z each; the steps throw an ArgumentError if they are null or empty, their number of coordinates is no
         *        multiple of 3, or one is not finite or beyond 1e100
         */
        public function InitialSimplex(vertices:Vector.<Number>)
        {
            _vertices = vertices;
            call(measure);
        }

        /**
         * Whether a set of three dimensions is thin across the coordinate axes, so that on a grid along those it would lose
         * precision.
         */
        public function get isThin():Boolean
        {
            var extents:Number = (_bounds.maxX - _bounds.minX) * (_bounds.maxY - _bounds.minY) * (_bounds.maxZ - _bounds.minZ);
            var spanned:Number = 1;
            for (var i:int = 0; i < 3; i++)
            {
                spanned *= Math.abs(along(i, corners[i + 1]) - along(i, corners[0]));
            }
            return spanned < Tolerances.HULL_THIN * extents;
        }

        private function measure():void
        {
            if (_vertices == null || _vertices.length == 0 || _vertices.length % 3 != 0)
            {
                throw new ArgumentError(VertexData.vertexProblem(_vertices));
            }
            slices(_vertices.length / 3, VERTICES_PER_STEP, measureSome).call(checkBounds).call(findCorner);
        }

        private function measureSome(first:int, end:int):void
        {
            _bounds.add(_vertices, first, end);
        }

        private function checkBounds():void
        {
            if (!_bounds.areFinite)
            {
                throw new ArgumentError(VertexData.vertexProblem(_vertices));
            }
            extent = _bounds.extent;
            VertexBounds.requireWithin(_bounds.largest);
            _flat = Tolerances.HULL_FLAT * extent + Tolerances.HULL_ROUNDING * _bounds.largest;
        }

        // Adds the steps of finding the next corner.
        private function findCorner():void
        {
            _most = -1;
            slices(_vertices.length / 3, VERTICES_PER_STEP, look).call(addCorner);
        }

        private function addCorner():void
        {
            corners.push(_farthest);
            if ((corners.length == 1 || spans(_farthest)) && dimension < 3)
            {
                findCorner();
            }
        }

        // Looks for the vertex that is farthest from the box's middle, then from the first corner, from the line and from the plane.
        private function look(first:int, end:int):void
        {
            var vertices:Vector.<Number> = _vertices;
            var fromX:Number = (_bounds.minX + _bounds.maxX) / 2;
            var fromY:Number = (_bounds.minY + _bounds.maxY) / 2;
            var fromZ:Number = (_bounds.minZ + _bounds.maxZ) / 2;
            if (corners.length > 0)
            {
                fromX = vertices[3 * corners[0]];
                fromY = vertices[3 * corners[0] + 1];
                fromZ = vertices[3 * corners[0] + 2];
            }
            var i:int;
            // only the axes that are not spanned count
            var across:Vector.<Number> = axes.concat();
            for (i = 0; i < 3 * dimension; i++)
            {
                across[i] = 0;
            }
            var aX:Number = across[0];
            var aY:Number = across[1];
            var aZ:Number = across[2];
            var bX:Number = across[3];
            var bY:Number = across[4];
            var bZ:Number = across[5];
            var cX:Number = across[6];
            var cY:Number = across[7];
            var cZ:Number = across[8];
            var last:int = 3 * end;
            for (i = 3 * first; i < last; i += 3)
            {
                var x:Number = vertices[i] - fromX;
                var y:Number = vertices[int(i + 1)] - fromY;
                var z:Number = vertices[int(i + 2)] - fromZ;
                var a:Number = x * aX + y * aY + z * aZ;
                var b:Number = x * bX + y * bY + z * bZ;
                var c:Number = x * cX + y * cY + z * cZ;
                var square:Number = a * a + b * b + c * c;
                if (square > _most)
                {
                    _most = square;
                    _farthest = i / 3;
                }
            }
        }

        // Whether a vertex is outside of what is spanned so far. Then that has one dimension more, and an axis towards the vertex.
        private function spans(vertex:int):Boolean
        {
            var from:int = 3 * corners[0];
            var x:Number = _vertices[3 * vertex] - _vertices[from];
            var y:Number = _vertices[3 * vertex + 1] - _vertices[from + 1];
            var z:Number = _vertices[3 * vertex + 2] - _vertices[from + 2];
            // twice: what rounding leaves along the axes counts if the vertex is close to them
            for (var i:int = 0; i < 2 * dimension; i++)
            {
                var axis:int = 3 * (i % dimension);
                var t:Number = x * axes[axis] + y * axes[axis + 1] + z * axes[axis + 2];
                x -= t * axes[axis];
                y -= t * axes[axis + 1];
                z -= t * axes[axis + 2];
            }
            if (!(Math.sqrt(x * x + y * y + z * z) > _flat))
            {
                return false;
            }
            if (dimension < 2)
            {
                setAxis(dimension, x, y, z);
            }
            if (dimension == 0)
            {
                setAxisAcross(Math.abs(x), Math.abs(y), Math.abs(z));
            }
            setAxis(2, axes[1] * axes[5] - axes[2] * axes[4], axes[2] * axes[3] - axes[0] * axes[5],
                    axes[0] * axes[4] - axes[1] * axes[3]);
            dimension++;
            return true;
        }

        // Turns the second axis across the first, and across the coordinate axis that the first is farthest from.
        private function setAxisAcross(alongX:Number, alongY:Number, alongZ:Number):void
        {
            if (alongX <= alongY && alongX <= alongZ)
            {
                setAxis(1, 0, axes[2], -axes[1]);
            }
            else if (alongY <= alongZ)
            {
                setAxis(1, -axes[2], 0, axes[0]);
            }
            else
            {
                setAxis(1, axes[1], -axes[0], 0);
            }
        }

        private function along(axis:int, vertex:int):Number
        {
            return _vertices[3 * vertex] * axes[3 * axis] + _vertices[3 * vertex + 1] * axes[3 * axis + 1]
                + _vertices[3 * vertex + 2] * axes[3 * axis + 2];
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
