package starlogo.fitting.hull
{
    import starlogo.data.IntSet;
    import starlogo.geometry.Tolerances;
    import starlogo.geometry.hull.edgesAcross;

    /**
     * A progressive hull (Sander, Gu, Gortler, Hoppe and Snyder, "Silhouette Clipping", SIGGRAPH 2000): a convex solid of triangles whose edges
     * collapse, so that it has fewer corners and grows. A new corner outside of all faces at both ends takes the place of an edge. These faces and
     * both ends are then inside of the solid.
     *
     * <p>The coordinates of corners are about 1. Faces and edges are numbered, and keep their numbers. Edge 3 f + k is an edge of face f,
     * with k from 0 to 2. It runs from one corner of the face to the next one, counter-clockwise seen from outside. The face across has
     * another edge, which runs the other way.</p>
     *
     * @private
     */
    public final class ProgressiveHull
    {
        // An edge with more faces than this at its ends does not collapse. So a corner with an edge to all others costs no more than other corners.
        private static const MAX_FACES:int = 40;

        private var _points:Vector.<Number>;

        // By edge: the corner at which it begins, and the edge that runs the other way.
        private var _corners:Vector.<int> = new Vector.<int>();
        private var _across:Vector.<int> = new Vector.<int>();

        // By face: the normal and the offset of its plane, and twice its area.
        private var _planes:Vector.<Number> = new Vector.<Number>();
        private var _areas:Vector.<Number> = new Vector.<Number>();

        // By face: 1 if it is buried, inside of the solid by now, otherwise 0.
        private var _isBuried:Vector.<int> = new Vector.<int>();

        // The faces that the present search has found.
        private var _found:IntSet = new IntSet();

        // The number of faces of the present surface.
        private var _surfaceFaceCount:int = 0;

        /**
         * @param points x, y, z of each corner; copied
         * @param triangles three corners each, counter-clockwise seen from outside
         */
        public function ProgressiveHull(points:Vector.<Number>, triangles:Vector.<int>)
        {
            _points = points.concat();
            for (var i:int = 0; i < triangles.length; i += 3)
            {
                addFace(triangles[i], triangles[i + 1], triangles[i + 2]);
            }
            _across = edgesAcross(triangles, points.length / 3);
        }

        /** The number of corners. A closed surface of triangles has two more than half the number of its faces (Euler). */
        public function get cornerCount():int
        {
            return 2 + _surfaceFaceCount / 2;
        }

        /** The number of faces so far, with those that are inside by now. */
        public function get faceCount():int
        {
            return _areas.length;
        }

        /** Lists the corners, x, y, z of each. */
        public function listCorners():Vector.<Number>
        {
            var result:Vector.<Number> = new Vector.<Number>();
            var isListed:Vector.<Boolean> = new Vector.<Boolean>(_points.length / 3);
            for (var edge:int = 0; edge < _corners.length; edge++)
            {
                var corner:int = _corners[edge];
                if (isOnSurface(edge) && !isListed[corner])
                {
                    isListed[corner] = true;
                    result.push(_points[3 * corner], _points[3 * corner + 1], _points[3 * corner + 2]);
                }
            }
            return result;
        }

        /** Whether an edge is on the present surface. */
        public function isOnSurface(edge:int):Boolean
        {
            return _isBuried[faceOf(edge)] == 0;
        }

        /** The corner at which an edge begins. */
        public function startOf(edge:int):int
        {
            return _corners[edge];
        }

        /** The corner at which an edge ends. */
        public function endOf(edge:int):int
        {
            return _corners[after(edge)];
        }

        /** The edge of the face across that runs the other way. */
        public function acrossOf(edge:int):int
        {
            return _across[edge];
        }

        /** The edge of the present surface that is where an earlier edge was; -1 if there is none. */
        public function currentEdge(edge:int):int
        {
            while (!isOnSurface(edge))
            {
                var other:int = _across[edge];
                if (_across[other] == edge)
                {
                    return -1;
                }
                edge = other;
            }
            return edge;
        }

        /** The shortest edge of a face. */
        public function shortestEdge(face:int):int
        {
            return shortest(3 * face, 3 * face + 3, 1);
        }

        /** The shortest edge at the corner that collapse() made last. @param face the first new face */
        public function shortestNewEdge(face:int):int
        {
            return shortest(3 * face + 1, 3 * faceCount, 3);
        }

        private function shortest(first:int, end:int, step:int):int
        {
            var found:int = -1;
            var least:Number = Infinity;
            for (var edge:int = first; edge < end; edge += step)
            {
                var a:int = 3 * startOf(edge);
                var b:int = 3 * endOf(edge);
                var x:Number = _points[b] - _points[a];
                var y:Number = _points[b + 1] - _points[a + 1];
                var z:Number = _points[b + 2] - _points[a + 2];
                var square:Number = x * x + y * y + z * z;
                if (square < least)
                {
                    least = square;
                    found = edge;
                }
            }
            return found;
        }

        /**
         * Finds the collapse of an edge for which the solid grows least.
         *
         * @param edge an edge of the present surface
         * @return whether the edge can collapse; otherwise <code>out</code> has no meaning
         */
        public function findCollapse(edge:int, out:EdgeCollapse):Boolean
        {
            out.faceCount = 0;
            _found.clear(faceCount);
            findFaces(edge, out);
            findFaces(_across[edge], out);
            var upX:Number = 0;
            var upY:Number = 0;
            var upZ:Number = 0;
            var count:int = out.faceCount;
            for (var i:int = 0; i < count; i++)
            {
                var face:int = out.faces[i];
                var area:Number = _areas[face];
                upX += area * _planes[int(4 * face)];
                upY += area * _planes[int(4 * face + 1)];
                upZ += area * _planes[int(4 * face + 2)];
            }
            if (count > MAX_FACES || !LowestPointSearch.find(_planes, upX, upY, upZ, out))
            {
                return false;
            }
            findSeen(out);
            return true;
        }

        /**
         * Collapses an edge. Faces from the new corner to the outline of the faces that it sees take their place.
         *
         * @param by what findCollapse() has found since the last collapse
         * @return the first new face; the others follow. -1 if rounding leaves the faces more than one outline; then the hull stays as it is
         */
        public function collapse(by:EdgeCollapse):int
        {
            setBuried(by.faces, by.faceCount, 1);
            var outline:Vector.<int> = outlineOf(by);
            if (outline.length == 0)
            {
                setBuried(by.faces, by.faceCount, 0);
                return -1;
            }
            _surfaceFaceCount -= by.faceCount;
            var corner:int = _points.length / 3;
            _points.push(by.x, by.y, by.z);
            var first:int = faceCount;
            var made:int = first;
            for each (var edge:int in outline)
            {
                made = addFace(startOf(edge), endOf(edge), corner);
                join(3 * made, _across[edge]);
                if (made > first)
                {
                    join(3 * made + 2, 3 * (made - 1) + 1);
                }
            }
            join(3 * first + 2, 3 * made + 1);
            return first;
        }

        // Adds the faces around the start of an edge to the faces that go, unless this search has found them already.
        private function findFaces(edge:int, out:EdgeCollapse):void
        {
            var marks:Vector.<int> = _found.marks;
            var mark:int = _found.mark;
            var count:int = out.faceCount;
            var next:int = edge;
            do
            {
                var face:int = next / 3;
                if (marks[face] != mark)
                {
                    marks[face] = mark;
                    out.faces[count] = face;
                    count++;
                }
                next = _across[next == 3 * face ? next + 2 : next - 1];
            }
            while (next != edge && count <= MAX_FACES);
            out.faceCount = count;
        }

        // Adds the faces that the new corner sees to the faces at the edge, and sums the volume between the corner and all of them.
        private function findSeen(by:EdgeCollapse):void
        {
            var planes:Vector.<Number> = _planes;
            var marks:Vector.<int> = _found.marks;
            var mark:int = _found.mark;
            var faces:Vector.<int> = by.faces;
            var count:int = by.faceCount;
            var x:Number = by.x;
            var y:Number = by.y;
            var z:Number = by.z;
            var sum:Number = 0;
            for (var i:int = 0; i < count; i++)
            {
                var face:int = faces[i];
                var first:int = 4 * face;
                var height:Number = planes[first] * x + planes[int(first + 1)] * y + planes[int(first + 2)] * z - planes[int(first + 3)];
                sum += height > 0 ? height * _areas[face] : 0;
                for (var edge:int = 3 * face; edge < 3 * face + 3; edge++)
                {
                    var neighbor:int = faceOf(_across[edge]);
                    if (marks[neighbor] == mark)
                    {
                        continue;
                    }
                    var at:int = 4 * neighbor;
                    height = planes[at] * x + planes[int(at + 1)] * y + planes[int(at + 2)] * z - planes[int(at + 3)];
                    if (height > Tolerances.UNIT_ROUNDING)
                    {
                        marks[neighbor] = mark;
                        faces[count] = neighbor;
                        count++;
                    }
                }
            }
            by.faceCount = count;
            by.growth = sum / 6;
        }

        private function setBuried(faces:Vector.<int>, count:int, value:int):void
        {
            for (var i:int = 0; i < count; i++)
            {
                _isBuried[faces[i]] = value;
            }
        }

        // The edges around the faces that a new corner sees, which are inside by now, one after the other. None if rounding leaves more than one
        // outline.
        private function outlineOf(by:EdgeCollapse):Vector.<int>
        {
            var total:int = 0;
            var first:int = -1;
            for (var i:int = 0; i < by.faceCount; i++)
            {
                var face:int = by.faces[i];
                for (var edge:int = 3 * face; edge < 3 * face + 3; edge++)
                {
                    if (isBorder(edge))
                    {
                        total++;
                        first = edge;
                    }
                }
            }
            var outline:Vector.<int> = new Vector.<int>();
            edge = first;
            while (outline.length < total && (edge != first || outline.length == 0))
            {
                outline.push(edge);
                edge = after(edge);
                while (!isBorder(edge))
                {
                    edge = after(_across[edge]);
                }
            }
            return outline.length == total && edge == first ? outline : new Vector.<int>();
        }

        private function isBorder(edge:int):Boolean
        {
            return isOnSurface(_across[edge]);
        }

        private function join(edge:int, other:int):void
        {
            _across[edge] = other;
            _across[other] = edge;
        }

        // Adds a face, which is not joined to others yet. Returns its number.
        private function addFace(a:int, b:int, c:int):int
        {
            var i:int = 3 * a;
            var j:int = 3 * b;
            var k:int = 3 * c;
            var abX:Number = _points[j] - _points[i];
            var abY:Number = _points[j + 1] - _points[i + 1];
            var abZ:Number = _points[j + 2] - _points[i + 2];
            var acX:Number = _points[k] - _points[i];
            var acY:Number = _points[k + 1] - _points[i + 1];
            var acZ:Number = _points[k + 2] - _points[i + 2];
            var x:Number = abY * acZ - abZ * acY;
            var y:Number = abZ * acX - abX * acZ;
            var z:Number = abX * acY - abY * acX;
            var length:Number = Math.sqrt(x * x + y * y + z * z);
            // A face without area has no plane. It gets a plane that no point is outside of.
            var scale:Number = length > Tolerances.UNIT_ROUNDING ? 1 / length : 0;
            x *= scale;
            y *= scale;
            z *= scale;
            var offset:Number = x * _points[i] + y * _points[i + 1] + z * _points[i + 2];
            offset = Math.max(offset, x * _points[j] + y * _points[j + 1] + z * _points[j + 2]);
            offset = Math.max(offset, x * _points[k] + y * _points[k + 1] + z * _points[k + 2]);
            // Numbers that are pushed would be boxed in Adobe's VM.
            var face:int = _areas.length;
            _areas[face] = length;
            _planes[4 * face] = x;
            _planes[4 * face + 1] = y;
            _planes[4 * face + 2] = z;
            _planes[4 * face + 3] = offset;
            _isBuried[face] = 0;
            _corners.push(a, b, c);
            _across.push(-1, -1, -1);
            _surfaceFaceCount++;
            return face;
        }

        private static function after(edge:int):int
        {
            return edge % 3 == 2 ? edge - 2 : edge + 1;
        }

        private static function faceOf(edge:int):int
        {
            return edge / 3;
        }
    }
}
