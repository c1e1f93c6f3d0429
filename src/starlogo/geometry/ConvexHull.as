package starlogo.geometry
{
    /**
     * The convex hull of a set of vertices: its corners and how they are joined.
     *
     * <p>Every vertex given is inside the hull or at most <code>Tolerances.HULL</code> of the set's extent outside it;
     * flat sides have vertices at their corners only. Sets that span no volume are fine: a plane's hull is a polygon, a line's
     * two points, and that of a single point (repeated or not) the point.</p>
     *
     * <p>Vertices are rounded to a grid of 2^25 steps along each of three axes, the coordinate axes or, for sets that are thin
     * in some other direction, axes along the set; on the grid the hull is exact (see QuickHull). What is handed out are the
     * vertices themselves, unrounded.</p>
     *
     * <p>Cost: n log n for n vertices. The work can be done in steps, each of about one pass over the vertices.</p>
     */
    public final class ConvexHull
    {
        private static const MEASURING:int = 0;
        private static const SPANNING:int = 1;
        private static const SNAPPING:int = 2;
        private static const HULLING:int = 3;
        private static const NUMBERING:int = 4;
        private static const MESHING:int = 5;
        private static const LINKING:int = 6;
        private static const FILLING:int = 7;
        private static const DONE:int = 8;

        // Beyond it the cubes and squares of coordinates overflow.
        private static const LARGEST:Number = 1e100;

        private var _vertices:Vector.<Number>;
        private var _count:int;
        private var _dimension:int;
        private var _axes:Vector.<Number>;
        private var _extent:Number = 0;
        private var _indices:Vector.<int>;
        private var _points:Vector.<Number>;
        private var _convexPoints:Vector.<Number>;
        private var _snapped:Vector.<Number>;
        private var _grid:Vector.<Number>;
        private var _triangles:Vector.<int> = new Vector.<int>();
        private var _firstNeighbor:Vector.<int>;
        private var _neighbors:Vector.<int>;
        private var _volume:Number = NaN;

        // The work under way.
        private var _phase:int = MEASURING;
        private var _box:Vector.<Number>;
        private var _flat:Number;
        private var _simplex:Vector.<int> = new Vector.<int>();
        private var _gridAxes:Vector.<Number>;
        private var _planarHull:PlanarHull;
        private var _quickHull:QuickHull;
        private var _place:Vector.<int>;
        private var _pairs:Vector.<int>;

        /**
         * Computes the hull.
         *
         * @param vertices x, y, z of each vertex, in any one unit; kept, not copied, and never changed
         * @param atOnce false leaves the work to <code>step()</code>: until no step is left, nothing but the vertices is to be
         *        asked for
         * @throws ArgumentError if it is null or empty, has a length that is no multiple of 3, or holds a number that is not
         *         finite or beyond 1e100
         */
        public function ConvexHull(vertices:Vector.<Number>, atOnce:Boolean = true)
        {
            checkLength(vertices);
            _vertices = vertices;
            _count = vertices.length / 3;
            var hasMore:Boolean = atOnce;
            while (hasMore)
            {
                hasMore = step();
            }
        }

        /**
         * Goes on with the hull, if it was not computed at once.
         *
         * @return whether there is more to do
         * @throws ArgumentError if a coordinate is not finite or beyond 1e100
         */
        public function step():Boolean
        {
            switch (_phase)
            {
                case MEASURING:
                    measureBox();
                    _phase = SPANNING;
                    break;
                case SPANNING:
                    span();
                    break;
                case SNAPPING:
                    snapNext();
                    break;
                case HULLING:
                    hull();
                    break;
                case NUMBERING:
                    numberCorners();
                    _phase = MESHING;
                    break;
                case MESHING:
                    makeTriangles();
                    _phase = LINKING;
                    break;
                case LINKING:
                    countNeighbors();
                    _phase = FILLING;
                    break;
                case FILLING:
                    fillNeighbors();
                    finish();
                    break;
            }
            return _phase != DONE;
        }

        /** The vertices that it was made of, x, y, z each: read only. */
        public function get vertices():Vector.<Number>
        {
            return _vertices;
        }

        /** 3 for a set that spans a volume, 2 for one in a plane, 1 on a line, 0 in a point. */
        public function get dimension():int
        {
            return _dimension;
        }

        /** The longest side of the axis-aligned box around the vertices. */
        public function get extent():Number
        {
            return _extent;
        }

        /**
         * Three perpendicular unit vectors, nine numbers: the first from one extreme vertex towards the one farthest from
         * it, the second from there towards the vertex farthest from that line. A plane's third is its normal.
         */
        public function get axes():Vector.<Number>
        {
            return _axes;
        }

        /** The hull's corners in ascending order, as positions in <code>vertices</code> (0 is the first vertex). */
        public function get indices():Vector.<int>
        {
            return _indices;
        }

        /** The hull's corners, x, y, z each, in the same order as <code>indices</code>. */
        public function get points():Vector.<Number>
        {
            return _points;
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
                _convexPoints = _snapped == null ? _points : placeOnGrid();
            }
            return _convexPoints;
        }

        /**
         * The hull's surface: three corners a triangle, as positions in <code>indices</code>, counter-clockwise seen from
         * outside; empty for a set that spans no volume.
         */
        public function get triangles():Vector.<int>
        {
            return _triangles;
        }

        /**
         * Where each corner's neighbours begin in <code>neighbors</code>, one entry more than there are corners: those of
         * corner i are at firstNeighbor[i] up to, not including, firstNeighbor[i + 1].
         */
        public function get firstNeighbor():Vector.<int>
        {
            return _firstNeighbor;
        }

        /** The corners that an edge of the hull joins to each corner, as positions in <code>indices</code>. */
        public function get neighbors():Vector.<int>
        {
            return _neighbors;
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

        private static function checkLength(vertices:Vector.<Number>):void
        {
            if (vertices == null)
            {
                throw new ArgumentError("the vertices must not be null");
            }
            if (vertices.length == 0 || vertices.length % 3 != 0)
            {
                throw new ArgumentError("the vertices must be x, y, z each, of at least one: the length is " + vertices.length);
            }
        }

        // Lets go of what was needed on the way.
        private function finish():void
        {
            _phase = DONE;
            _box = null;
            _simplex = null;
            _gridAxes = null;
            _planarHull = null;
            _quickHull = null;
            _place = null;
            _pairs = null;
        }

        // The least x, y, z and the greatest.
        private function measureBox():void
        {
            var lowX:Number = _vertices[0];
            var lowY:Number = _vertices[1];
            var lowZ:Number = _vertices[2];
            var highX:Number = lowX;
            var highY:Number = lowY;
            var highZ:Number = lowZ;
            var length:int = _vertices.length;
            for (var i:int = 0; i < length; i += 3)
            {
                var x:Number = _vertices[i];
                var y:Number = _vertices[i + 1];
                var z:Number = _vertices[i + 2];
                // not finite: infinity minus itself is NaN, which equals nothing
                if (x - x != 0 || y - y != 0 || z - z != 0)
                {
                    throw new ArgumentError("vertex " + i / 3 + " is not finite: (" + x + ", " + y + ", " + z + ")");
                }
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
            _extent = Math.max(highX - lowX, highY - lowY, highZ - lowZ);
            _box = new <Number>[lowX, lowY, lowZ, highX, highY, highZ];
        }

        // Finds one more of four extreme vertices; when it adds no dimension to the set, or all are found, the axes are set.
        private function span():void
        {
            var isHigher:Boolean = true;
            switch (_simplex.length)
            {
                case 0:
                    prepareAxes();
                    _simplex.push(farthestFrom((_box[0] + _box[3]) / 2, (_box[1] + _box[4]) / 2, (_box[2] + _box[5]) / 2));
                    return;
                case 1:
                    isHigher = spanLine(_simplex[0]);
                    break;
                case 2:
                    isHigher = spanPlane(_simplex[0]);
                    break;
                default:
                    isHigher = spanVolume(_simplex[0]);
            }
            if (isHigher)
            {
                _dimension++;
            }
            if (!isHigher || _dimension == 3)
            {
                chooseGrid();
            }
        }

        private function prepareAxes():void
        {
            _dimension = 0;
            _axes = new <Number>[1, 0, 0, 0, 1, 0, 0, 0, 1];
            var largest:Number = 0;
            for (var i:int = 0; i < 6; i++)
            {
                largest = Math.max(largest, Math.abs(_box[i]));
            }
            if (largest > LARGEST)
            {
                throw new ArgumentError("coordinates must be at most " + LARGEST + ": " + largest);
            }
            _flat = Tolerances.HULL_FLAT * _extent + Tolerances.HULL_ROUNDING * largest;
        }

        private function spanLine(a:int):Boolean
        {
            var b:int = farthestFrom(_vertices[3 * a], _vertices[3 * a + 1], _vertices[3 * a + 2]);
            _simplex.push(b);
            return alignFirst(a, b, _flat);
        }

        private function spanPlane(a:int):Boolean
        {
            var c:int = farthestFromLine(a);
            _simplex.push(c);
            return alignSecond(a, c, _flat);
        }

        private function spanVolume(a:int):Boolean
        {
            var d:int = farthestFromPlane(a);
            _simplex.push(d);
            return Math.abs(along(2, d) - along(2, a)) > _flat;
        }

        private function chooseGrid():void
        {
            if (_dimension < 2)
            {
                join(_dimension == 0 ? new <int>[_simplex[0]] : new <int>[_simplex[0], _simplex[1]]);
                finish();
                return;
            }
            _gridAxes = _dimension == 2 || isThin() ? _axes : new <Number>[1, 0, 0, 0, 1, 0, 0, 0, 1];
            _snapped = new Vector.<Number>(_dimension * _count);
            _grid = new Vector.<Number>();
            _phase = SNAPPING;
        }

        // Along the coordinate axes sides that are flat stay flat, but a set that is thin across them would lose precision.
        private function isThin():Boolean
        {
            var extents:Number = (_box[3] - _box[0]) * (_box[4] - _box[1]) * (_box[5] - _box[2]);
            var spanned:Number = 1;
            for (var i:int = 0; i < 3; i++)
            {
                spanned *= Math.abs(along(i, _simplex[i + 1]) - along(i, _simplex[0]));
            }
            return spanned < Tolerances.HULL_THIN * extents;
        }

        private function farthestFrom(x:Number, y:Number, z:Number):int
        {
            var farthest:int = 0;
            var most:Number = -1;
            var length:int = _vertices.length;
            for (var i:int = 0; i < length; i += 3)
            {
                var toX:Number = _vertices[i] - x;
                var toY:Number = _vertices[i + 1] - y;
                var toZ:Number = _vertices[i + 2] - z;
                var square:Number = toX * toX + toY * toY + toZ * toZ;
                if (square > most)
                {
                    most = square;
                    farthest = i;
                }
            }
            return farthest / 3;
        }

        private function farthestFromLine(from:int):int
        {
            var x:Number = _vertices[3 * from];
            var y:Number = _vertices[3 * from + 1];
            var z:Number = _vertices[3 * from + 2];
            var axisX:Number = _axes[0];
            var axisY:Number = _axes[1];
            var axisZ:Number = _axes[2];
            var farthest:int = 0;
            var most:Number = -1;
            var length:int = _vertices.length;
            for (var i:int = 0; i < length; i += 3)
            {
                var toX:Number = _vertices[i] - x;
                var toY:Number = _vertices[i + 1] - y;
                var toZ:Number = _vertices[i + 2] - z;
                var crossX:Number = toY * axisZ - toZ * axisY;
                var crossY:Number = toZ * axisX - toX * axisZ;
                var crossZ:Number = toX * axisY - toY * axisX;
                var square:Number = crossX * crossX + crossY * crossY + crossZ * crossZ;
                if (square > most)
                {
                    most = square;
                    farthest = i;
                }
            }
            return farthest / 3;
        }

        private function farthestFromPlane(from:int):int
        {
            var axisX:Number = _axes[6];
            var axisY:Number = _axes[7];
            var axisZ:Number = _axes[8];
            var offset:Number = along(2, from);
            var farthest:int = 0;
            var most:Number = -1;
            var length:int = _vertices.length;
            for (var i:int = 0; i < length; i += 3)
            {
                var distance:Number = _vertices[i] * axisX + _vertices[i + 1] * axisY + _vertices[i + 2] * axisZ - offset;
                if (distance < 0)
                {
                    distance = -distance;
                }
                if (distance > most)
                {
                    most = distance;
                    farthest = i;
                }
            }
            return farthest / 3;
        }

        private function along(axis:int, vertex:int):Number
        {
            return _vertices[3 * vertex] * _axes[3 * axis] + _vertices[3 * vertex + 1] * _axes[3 * axis + 1]
                + _vertices[3 * vertex + 2] * _axes[3 * axis + 2];
        }

        // Turns the first axis from vertex a to vertex b, the others perpendicular to it; false if the two coincide.
        private function alignFirst(a:int, b:int, flat:Number):Boolean
        {
            var x:Number = _vertices[3 * b] - _vertices[3 * a];
            var y:Number = _vertices[3 * b + 1] - _vertices[3 * a + 1];
            var z:Number = _vertices[3 * b + 2] - _vertices[3 * a + 2];
            var length:Number = Math.sqrt(x * x + y * y + z * z);
            if (!(length > flat))
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
        private function alignSecond(a:int, c:int, flat:Number):Boolean
        {
            var x:Number = _vertices[3 * c] - _vertices[3 * a];
            var y:Number = _vertices[3 * c + 1] - _vertices[3 * a + 1];
            var z:Number = _vertices[3 * c + 2] - _vertices[3 * a + 2];
            var t:Number = x * _axes[0] + y * _axes[1] + z * _axes[2];
            x -= t * _axes[0];
            y -= t * _axes[1];
            z -= t * _axes[2];
            if (!(Math.sqrt(x * x + y * y + z * z) > flat))
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

        private function snapNext():void
        {
            var axis:int = _grid.length / 5;
            if (axis < _dimension)
            {
                snap(axis);
                return;
            }
            _phase = HULLING;
            if (_dimension == 2)
            {
                _planarHull = new PlanarHull(_snapped);
                return;
            }
            _quickHull = new QuickHull(_snapped);
            _quickHull.begin(_simplex[0], _simplex[1], _simplex[2], _simplex[3]);
        }

        // The vertices' coordinates along one of the grid's axes, in whole steps of QuickHull's grid.
        private function snap(axis:int):void
        {
            var snapped:Vector.<Number> = _snapped;
            var dimensions:int = _dimension;
            var axisX:Number = _gridAxes[3 * axis];
            var axisY:Number = _gridAxes[3 * axis + 1];
            var axisZ:Number = _gridAxes[3 * axis + 2];
            var low:Number = Infinity;
            var high:Number = -Infinity;
            var length:int = _vertices.length;
            var to:int = axis;
            var i:int;
            for (i = 0; i < length; i += 3)
            {
                var t:Number = _vertices[i] * axisX + _vertices[i + 1] * axisY + _vertices[i + 2] * axisZ;
                snapped[to] = t;
                to += dimensions;
                if (t < low)
                {
                    low = t;
                }
                if (t > high)
                {
                    high = t;
                }
            }
            var scale:Number = QuickHull.GRID / (high - low);
            length = snapped.length;
            for (i = axis; i < length; i += dimensions)
            {
                snapped[i] = int((snapped[i] - low) * scale + 0.5);
            }
            _grid.push(axisX, axisY, axisZ, low, (high - low) / QuickHull.GRID);
        }

        private function hull():void
        {
            if (_dimension == 3)
            {
                _phase = _quickHull.step() ? HULLING : NUMBERING;
            }
            else if (!_planarHull.step())
            {
                join(_planarHull.corners);
                finish();
            }
        }

        private function placeOnGrid():Vector.<Number>
        {
            var dimensions:int = _grid.length / 5;
            var placed:Vector.<Number> = new Vector.<Number>(_points.length);
            // the points of a plane have the same place along its normal
            var height:Number = dimensions == 2 ? along(2, _indices[0]) : 0;
            for (var i:int = 0; i < placed.length; i += 3)
            {
                var x:Number = height * _axes[6];
                var y:Number = height * _axes[7];
                var z:Number = height * _axes[8];
                for (var axis:int = 0; axis < dimensions; axis++)
                {
                    var t:Number = _grid[5 * axis + 3] + _snapped[dimensions * _indices[i / 3] + axis] * _grid[5 * axis + 4];
                    x += t * _grid[5 * axis];
                    y += t * _grid[5 * axis + 1];
                    z += t * _grid[5 * axis + 2];
                }
                placed[i] = x;
                placed[i + 1] = y;
                placed[i + 2] = z;
            }
            return placed;
        }

        // A hull without triangles: its corners one after the other, the last joined to the first.
        private function join(loop:Vector.<int>):void
        {
            var count:int = loop.length;
            var sorted:Vector.<int> = loop.concat().sort(Array.NUMERIC);
            number(sorted);
            var place:Vector.<int> = new Vector.<int>(count);
            var i:int;
            for (i = 0; i < count; i++)
            {
                place[i] = sorted.indexOf(loop[i]);
            }
            var pairs:Vector.<int> = new Vector.<int>();
            for (i = 0; i < count && count > 1; i++)
            {
                var next:int = (i + 1) % count;
                pairs.push(place[i], place[next]);
                if (count > 2)
                {
                    pairs.push(place[next], place[i]);
                }
            }
            _pairs = pairs;
            countNeighbors();
            fillNeighbors();
        }

        private function numberCorners():void
        {
            var faces:Vector.<HullFace> = _quickHull.faces;
            var place:Vector.<int> = new Vector.<int>(_count);
            var count:int = faces.length;
            var i:int;
            for (i = 0; i < count; i++)
            {
                place[faces[i].a] = place[faces[i].b] = place[faces[i].c] = 1;
            }
            var corners:Vector.<int> = new Vector.<int>();
            for (i = 0; i < _count; i++)
            {
                if (place[i] == 1)
                {
                    place[i] = corners.length;
                    corners.push(i);
                }
            }
            number(corners);
            _place = place;
        }

        private function makeTriangles():void
        {
            var faces:Vector.<HullFace> = _quickHull.faces;
            var place:Vector.<int> = _place;
            var count:int = faces.length;
            var pairs:Vector.<int> = new Vector.<int>(6 * count);
            _triangles.length = 3 * count;
            for (var i:int = 0; i < count; i++)
            {
                var a:int = place[faces[i].a];
                var b:int = place[faces[i].b];
                var c:int = place[faces[i].c];
                var at:int = 3 * i;
                _triangles[at] = pairs[2 * at] = pairs[2 * at + 5] = a;
                _triangles[at + 1] = pairs[2 * at + 1] = pairs[2 * at + 2] = b;
                _triangles[at + 2] = pairs[2 * at + 3] = pairs[2 * at + 4] = c;
            }
            _pairs = pairs;
        }

        private function number(corners:Vector.<int>):void
        {
            _indices = corners;
            _points = new Vector.<Number>();
            var count:int = corners.length;
            for (var i:int = 0; i < count; i++)
            {
                var from:int = 3 * corners[i];
                _points.push(_vertices[from], _vertices[from + 1], _vertices[from + 2]);
            }
        }

        // Where each corner's neighbours are to be: there are pairs of a corner and a neighbour of it.
        private function countNeighbors():void
        {
            var pairs:Vector.<int> = _pairs;
            var length:int = pairs.length;
            var count:int = _indices.length;
            var first:Vector.<int> = new Vector.<int>(count + 1);
            var i:int;
            for (i = 0; i < length; i += 2)
            {
                first[int(pairs[i] + 1)]++;
            }
            for (i = 0; i < count; i++)
            {
                first[i + 1] += first[i];
            }
            _firstNeighbor = first;
        }

        private function fillNeighbors():void
        {
            var pairs:Vector.<int> = _pairs;
            var length:int = pairs.length;
            var next:Vector.<int> = _firstNeighbor.concat();
            _neighbors = new Vector.<int>(length / 2);
            for (var i:int = 0; i < length; i += 2)
            {
                _neighbors[next[pairs[i]]++] = pairs[int(i + 1)];
            }
        }

        // The sum of the tetrahedra from the first corner to each triangle.
        private function measure():Number
        {
            var fromX:Number = _points[0];
            var fromY:Number = _points[1];
            var fromZ:Number = _points[2];
            var sum:Number = 0;
            for (var i:int = 0; i < _triangles.length; i += 3)
            {
                var a:int = 3 * _triangles[i];
                var b:int = 3 * _triangles[i + 1];
                var c:int = 3 * _triangles[i + 2];
                var bX:Number = _points[b] - fromX;
                var bY:Number = _points[b + 1] - fromY;
                var bZ:Number = _points[b + 2] - fromZ;
                var cX:Number = _points[c] - fromX;
                var cY:Number = _points[c + 1] - fromY;
                var cZ:Number = _points[c + 2] - fromZ;
                sum += (_points[a] - fromX) * (bY * cZ - bZ * cY) + (_points[a + 1] - fromY) * (bZ * cX - bX * cZ)
                    + (_points[a + 2] - fromZ) * (bX * cY - bY * cX);
            }
            return sum / 6;
        }
    }
}
