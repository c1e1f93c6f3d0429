package starlogo.geometry
{
    import starlogo.steps.Steps;

    /**
     * Up to four vertices of a set that are far from each other, how many dimensions they span, and axes along them. Every
     * other vertex lies in the point, on the line or in the plane of fewer than four, up to Tolerances.HULL_FLAT and
     * HULL_ROUNDING. Each takes a pass over the vertices, in steps.
     */
    internal final class InitialSimplex implements Steps
    {
        // Beyond it the cubes and squares of coordinates overflow.
        private static const LARGEST:Number = 1e100;

        private static const VERTICES_A_STEP:int = 4000;

        private var _vertices:Vector.<Number>;

        // The least x, y, z and the greatest; the sum of all coordinates, which is finite if they are.
        private var _box:Vector.<Number> = null;
        private var _sum:Number = 0;
        private var _isMeasured:Boolean = false;

        // The pass under way: the next vertex, and the one farthest from the corners so far.
        private var _next:int = 0;
        private var _farthest:FarthestVertex;

        private var _extent:Number = 0;
        private var _flat:Number;
        private var _dimension:int = 0;
        private var _axes:Vector.<Number> = new <Number>[1, 0, 0, 0, 1, 0, 0, 0, 1];
        private var _corners:Vector.<int> = new Vector.<int>();

        /**
         * @param vertices x, y, z each
         */
        public function InitialSimplex(vertices:Vector.<Number>)
        {
            _vertices = vertices;
        }

        /**
         * @inheritDoc
         *
         * @throws ArgumentError if the vertices are null or empty, their number of coordinates is no multiple of 3, or one is not
         *         finite or beyond 1e100
         */
        public function step():Boolean
        {
            if (_box == null)
            {
                beginBox();
            }
            var first:int = _next;
            var end:int = Math.min(first + VERTICES_A_STEP, _vertices.length / 3);
            _next = end;
            if (_isMeasured)
            {
                look(first, end);
            }
            else
            {
                measureBox(first, end);
            }
            return end < _vertices.length / 3 || finishPass();
        }

        /** The longest side of the axis-aligned box around the vertices. */
        public function get extent():Number
        {
            return _extent;
        }

        /** 3 for a set that spans a volume, 2 for one in a plane, 1 on a line, 0 in a point. */
        public function get dimension():int
        {
            return _dimension;
        }

        /** Three perpendicular unit vectors: see ConvexHull. */
        public function get axes():Vector.<Number>
        {
            return _axes;
        }

        /** The vertices, by their numbers: at least one more than dimensions. */
        public function get corners():Vector.<int>
        {
            return _corners;
        }

        /**
         * Whether a set of three dimensions is thin across the coordinate axes, so that on a grid along those it would lose
         * precision.
         */
        public function get isThin():Boolean
        {
            var extents:Number = (_box[3] - _box[0]) * (_box[4] - _box[1]) * (_box[5] - _box[2]);
            var spanned:Number = 1;
            for (var i:int = 0; i < 3; i++)
            {
                spanned *= Math.abs(along(i, _corners[i + 1]) - along(i, _corners[0]));
            }
            return spanned < Tolerances.HULL_THIN * extents;
        }

        private function beginBox():void
        {
            if (_vertices == null || _vertices.length == 0 || _vertices.length % 3 != 0)
            {
                refuseIfWrong();
            }
            _box = new <Number>[_vertices[0], _vertices[1], _vertices[2], _vertices[0], _vertices[1], _vertices[2]];
        }

        private function measureBox(first:int, end:int):void
        {
            var lowX:Number = _box[0];
            var lowY:Number = _box[1];
            var lowZ:Number = _box[2];
            var highX:Number = _box[3];
            var highY:Number = _box[4];
            var highZ:Number = _box[5];
            var sum:Number = _sum;
            var last:int = 3 * end;
            for (var i:int = 3 * first; i < last; i += 3)
            {
                var x:Number = _vertices[i];
                var y:Number = _vertices[i + 1];
                var z:Number = _vertices[i + 2];
                sum += x + y + z;
                if (x < lowX)
                {
                    lowX = x;
                }
                else if (x > highX)
                {
                    highX = x;
                }
                if (y < lowY)
                {
                    lowY = y;
                }
                else if (y > highY)
                {
                    highY = y;
                }
                if (z < lowZ)
                {
                    lowZ = z;
                }
                else if (z > highZ)
                {
                    highZ = z;
                }
            }
            _sum = sum;
            _box[0] = lowX;
            _box[1] = lowY;
            _box[2] = lowZ;
            _box[3] = highX;
            _box[4] = highY;
            _box[5] = highZ;
        }

        // Whether there is another one.
        private function finishPass():Boolean
        {
            var isHigher:Boolean = true;
            if (!_isMeasured)
            {
                takeBox();
                _isMeasured = true;
            }
            else
            {
                _corners.push(_farthest.index);
                isHigher = _corners.length == 1 || span(_corners[0], _farthest.index);
            }
            _next = 0;
            _farthest = new FarthestVertex(_vertices);
            return isHigher && _dimension < 3;
        }

        private function takeBox():void
        {
            // the sum of numbers that are not all finite is not either, nor that of numbers too large
            if (_sum - _sum != 0)
            {
                refuseIfWrong();
            }
            _extent = Math.max(_box[3] - _box[0], _box[4] - _box[1], _box[5] - _box[2]);
            var largest:Number = Math.max(-_box[0], -_box[1], -_box[2], _box[3], _box[4], _box[5]);
            if (largest > LARGEST)
            {
                throw new ArgumentError("coordinates must be at most " + LARGEST + ": " + largest);
            }
            _flat = Tolerances.HULL_FLAT * _extent + Tolerances.HULL_ROUNDING * largest;
        }

        private function refuseIfWrong():void
        {
            var problem:String = VertexData.vertexProblem(_vertices);
            if (problem != null)
            {
                throw new ArgumentError(problem);
            }
        }

        // Whether the last corner lies in one dimension more than the others.
        private function span(a:int, last:int):Boolean
        {
            var isHigher:Boolean;
            switch (_dimension)
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
                _dimension++;
            }
            return isHigher;
        }

        // For what is farthest from the box's middle, then from the first corner, from the line and from the plane.
        private function look(first:int, end:int):void
        {
            var box:Vector.<Number> = _box;
            var corner:int = _corners.length == 0 ? 0 : 3 * _corners[0];
            var x:Number = _vertices[corner];
            var y:Number = _vertices[corner + 1];
            var z:Number = _vertices[corner + 2];
            switch (_corners.length)
            {
                case 0:
                    _farthest.lookFromPoint((box[0] + box[3]) / 2, (box[1] + box[4]) / 2, (box[2] + box[5]) / 2, first, end);
                    break;
                case 1:
                    _farthest.lookFromPoint(x, y, z, first, end);
                    break;
                case 2:
                    _farthest.lookFromLine(x, y, z, _axes[0], _axes[1], _axes[2], first, end);
                    break;
                default:
                    _farthest.lookFromPlane(_axes[6], _axes[7], _axes[8], along(2, _corners[0]), first, end);
            }
        }

        private function along(axis:int, vertex:int):Number
        {
            return _vertices[3 * vertex] * _axes[3 * axis] + _vertices[3 * vertex + 1] * _axes[3 * axis + 1]
                + _vertices[3 * vertex + 2] * _axes[3 * axis + 2];
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
            var t:Number = x * _axes[0] + y * _axes[1] + z * _axes[2];
            x -= t * _axes[0];
            y -= t * _axes[1];
            z -= t * _axes[2];
            if (!(Math.sqrt(x * x + y * y + z * z) > _flat))
            {
                return false;
            }
            setAxis(1, x, y, z);
            // once more: what was left along the first axis counts when c is close to the line
            t = _axes[3] * _axes[0] + _axes[4] * _axes[1] + _axes[5] * _axes[2];
            setAxis(1, _axes[3] - t * _axes[0], _axes[4] - t * _axes[1], _axes[5] - t * _axes[2]);
            setThirdAxis();
            return true;
        }

        private function setAxis(axis:int, x:Number, y:Number, z:Number):void
        {
            var length:Number = Math.sqrt(x * x + y * y + z * z);
            _axes[3 * axis] = x / length;
            _axes[3 * axis + 1] = y / length;
            _axes[3 * axis + 2] = z / length;
        }

        private function setThirdAxis():void
        {
            setAxis(2, _axes[1] * _axes[5] - _axes[2] * _axes[4], _axes[2] * _axes[3] - _axes[0] * _axes[5],
                    _axes[0] * _axes[4] - _axes[1] * _axes[3]);
        }
    }
}
