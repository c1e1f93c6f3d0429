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
        // Beyond it the cubes and squares of coordinates overflow.
        private static const LARGEST:Number = 1e100;

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
        private var _farthest:FarthestVertex;
        private var _flat:Number;

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
            var largest:Number = Math.max(-_bounds.minX, -_bounds.minY, -_bounds.minZ, _bounds.maxX, _bounds.maxY, _bounds.maxZ);
            if (largest > LARGEST)
            {
                throw new ArgumentError("coordinates must be at most " + LARGEST + ": " + largest);
            }
            _flat = Tolerances.HULL_FLAT * extent + Tolerances.HULL_ROUNDING * largest;
        }

        // Adds the steps of finding the next corner.
        private function findCorner():void
        {
            _farthest = new FarthestVertex(_vertices);
            slices(_vertices.length / 3, VERTICES_PER_STEP, look).call(addCorner);
        }

        private function addCorner():void
        {
            corners.push(_farthest.index);
            if ((corners.length == 1 || spans(corners[0], _farthest.index)) && dimension < 3)
            {
                findCorner();
            }
        }

        // Looks for the vertex that is farthest from the box's middle, then from the first corner, from the line and from the plane.
        private function look(first:int, end:int):void
        {
            var corner:int = corners.length == 0 ? 0 : 3 * corners[0];
            var x:Number = _vertices[corner];
            var y:Number = _vertices[corner + 1];
            var z:Number = _vertices[corner + 2];
            switch (corners.length)
            {
                case 0:
                    _farthest.lookFromPoint((_bounds.minX + _bounds.maxX) / 2, (_bounds.minY + _bounds.maxY) / 2,
                            (_bounds.minZ + _bounds.maxZ) / 2, first, end);
                    break;
                case 1:
                    _farthest.lookFromPoint(x, y, z, first, end);
                    break;
                case 2:
                    _farthest.lookFromLine(x, y, z, axes[0], axes[1], axes[2], first, end);
                    break;
                default:
                    _farthest.lookFromPlane(axes[6], axes[7], axes[8], along(2, corners[0]), first, end);
            }
        }

        // Whether the last corner lies in one dimension more than the others.
        private function spans(a:int, last:int):Boolean
        {
            var isHigher:Boolean;
            switch (dimension)
            {
                case 0:
                    isHigher = alignFirst(a, last);
                    break;
                case 1:
                    isHigher = alignSecond(a, last);
                    break;
                default:
                    isHigher = Math.abs(along(2, last) - along(2, a)) > _flat;
            }
            if (isHigher)
            {
                dimension++;
            }
            return isHigher;
        }

        private function along(axis:int, vertex:int):Number
        {
            return _vertices[3 * vertex] * axes[3 * axis] + _vertices[3 * vertex + 1] * axes[3 * axis + 1]
                + _vertices[3 * vertex + 2] * axes[3 * axis + 2];
        }

        // Turns the first axis from vertex a to vertex b, the others perpendicular to it; false if the two coincide.
        private function alignFirst(a:int, b:int):Boolean
        {
            var x:Number = _vertices[3 * b] - _vertices[3 * a];
            var y:Number = _vertices[3 * b + 1] - _vertices[3 * a + 1];
            var z:Number = _vertices[3 * b + 2] - _vertices[3 * a + 2];
            var length:Number = Math.sqrt(x * x + y * y + z * z);
            if (!(length > _flat))
            {
                return false;
            }
            x /= length;
            y /= length;
            z /= length;
            setAxis(0, x, y, z);
            // across the coordinate axis that it is farthest from
            if (Math.abs(x) <= Math.abs(y) && Math.abs(x) <= Math.abs(z))
            {
                setAxis(1, 0, z, -y);
            }
            else if (Math.abs(y) <= Math.abs(z))
            {
                setAxis(1, -z, 0, x);
            }
            else
            {
                setAxis(1, y, -x, 0);
            }
            setThirdAxis();
            return true;
        }

        // Turns the second axis towards vertex c; false if that lies on the line through vertex a along the first.
        private function alignSecond(a:int, c:int):Boolean
        {
            var x:Number = _vertices[3 * c] - _vertices[3 * a];
            var y:Number = _vertices[3 * c + 1] - _vertices[3 * a + 1];
            var z:Number = _vertices[3 * c + 2] - _vertices[3 * a + 2];
            var t:Number = x * axes[0] + y * axes[1] + z * axes[2];
            x -= t * axes[0];
            y -= t * axes[1];
            z -= t * axes[2];
            if (!(Math.sqrt(x * x + y * y + z * z) > _flat))
            {
                return false;
            }
            setAxis(1, x, y, z);
            // once more: what was left along the first axis counts when c is close to the line
            t = axes[3] * axes[0] + axes[4] * axes[1] + axes[5] * axes[2];
            setAxis(1, axes[3] - t * axes[0], axes[4] - t * axes[1], axes[5] - t * axes[2]);
            setThirdAxis();
            return true;
        }

        private function setAxis(axis:int, x:Number, y:Number, z:Number):void
        {
            var length:Number = Math.sqrt(x * x + y * y + z * z);
            axes[3 * axis] = x / length;
            axes[3 * axis + 1] = y / length;
            axes[3 * axis + 2] = z / length;
        }

        private function setThirdAxis():void
        {
            setAxis(2, axes[1] * axes[5] - axes[2] * axes[4], axes[2] * axes[3] - axes[0] * axes[5],
                    axes[0] * axes[4] - axes[1] * axes[3]);
        }
    }
}
