package starlogo.models
{
    /**
     * Cuts polygons in space into triangles: concave ones, and ones with holes.
     *
     * <p>A polygon is seen along the axis nearest to its normal (M. E. Newell's), which keeps every turn of its
     * outline; a small bend out of its plane does no harm. Holes are joined to the outline by a bridge each (D.
     * Eberly, "Triangulation by Ear Clipping", 2002), then ears are cut off. Corners in a straight line, and outlines
     * that cross or cover themselves, leave no triangle without area behind.</p>
     *
     * <p>Cost: linear for convex polygons, else up to quadratic in the corners. The whole work is bounded by
     * <code>MAX_WORK</code>: beyond it corners are cut off unseen, and holes filled.</p>
     */
    internal final class Triangulator
    {
        /** How many corners one triangulator looks at in all, some seconds' worth. */
        internal static const MAX_WORK:int = 10000000;

        private var _vertices:Vector.<Number>;
        private var _triangles:Vector.<uint>;
        private var _work:int = 0;

        // the corners as nodes of rings: position seen along the normal, vertex, neighbours
        private var _x:Vector.<Number> = new Vector.<Number>();
        private var _y:Vector.<Number> = new Vector.<Number>();
        private var _vertex:Vector.<uint> = new Vector.<uint>();
        private var _next:Vector.<int> = new Vector.<int>();
        private var _previous:Vector.<int> = new Vector.<int>();

        // which coordinates the two seen ones are, and the scale that keeps their products in range
        private var _axisX:int;
        private var _axisY:int;
        private var _scale:Number;

        /**
         * @param vertices x, y, z, ... that the polygons' corners index
         * @param triangles where the triangles go, three indices each, turning as their polygon turns
         */
        public function Triangulator(vertices:Vector.<Number>, triangles:Vector.<uint>)
        {
            _vertices = vertices;
            _triangles = triangles;
        }

        /** Cuts a polygon with four corners along the diagonal that lies inside. */
        public function addQuad(a:uint, b:uint, c:uint, d:uint):void
        {
            if (!isDiagonal(a, b, c, d) && isDiagonal(b, c, d, a))
            {
                addTriangle(a, b, d);
                addTriangle(b, c, d);
            }
            else
            {
                addTriangle(a, b, c);
                addTriangle(a, c, d);
            }
        }

        /**
         * Cuts a polygon.
         *
         * @param loops the corners of its outline, then of each hole; a hole may turn either way
         */
        public function addPolygon(loops:Vector.<Vector.<uint>>):void
        {
            var outline:Vector.<uint> = loops[0];
            if (loops.length == 1 && outline.length < 5)
            {
                addSmall(outline);
                return;
            }
            if (!lookAt(outline))
            {
                return;
            }
            clear();
            var start:int = addLoop(outline, true);
            if (loops.length == 1 && addFan(outline.length))
            {
                return;
            }
            for each (var hole:int in holesFromTheRight(loops))
            {
                addBridge(start, hole);
            }
            cutEars(start);
        }

        private function addSmall(outline:Vector.<uint>):void
        {
            if (outline.length == 3)
            {
                addTriangle(outline[0], outline[1], outline[2]);
            }
            else if (outline.length == 4)
            {
                addQuad(outline[0], outline[1], outline[2], outline[3]);
            }
        }

        private function addTriangle(a:uint, b:uint, c:uint):void
        {
            if (a != b && b != c && c != a)
            {
                _triangles.push(a, b, c);
            }
        }

        /** Whether the two triangles that ac makes of a quad turn the same way. */
        private function isDiagonal(a:uint, b:uint, c:uint, d:uint):Boolean
        {
            var start:int = 3 * a;
            var x:Number = _vertices[start];
            var y:Number = _vertices[int(start + 1)];
            var z:Number = _vertices[int(start + 2)];
            start = 3 * b;
            var bx:Number = _vertices[start] - x;
            var by:Number = _vertices[int(start + 1)] - y;
            var bz:Number = _vertices[int(start + 2)] - z;
            start = 3 * c;
            var cx:Number = _vertices[start] - x;
            var cy:Number = _vertices[int(start + 1)] - y;
            var cz:Number = _vertices[int(start + 2)] - z;
            start = 3 * d;
            var dx:Number = _vertices[start] - x;
            var dy:Number = _vertices[int(start + 1)] - y;
            var dz:Number = _vertices[int(start + 2)] - z;
            return (by * cz - bz * cy) * (cy * dz - cz * dy) + (bz * cx - bx * cz) * (cz * dx - cx * dz) +
                (bx * cy - by * cx) * (cx * dy - cy * dx) > 0;
        }

        /** Chooses where to look from; false if the outline has no area. */
        private function lookAt(outline:Vector.<uint>):Boolean
        {
            var origin:int = 3 * outline[0];
            var extent:Number = 0;
            for each (var corner:uint in outline)
            {
                for (var i:int = 0; i < 3; i++)
                {
                    extent = Math.max(extent, Math.abs(_vertices[3 * corner + i] - _vertices[origin + i]));
                }
            }
            _scale = 1 / extent;
            var normal:Vector.<Number> = new <Number>[
                    doubleArea(outline, 1, 2), doubleArea(outline, 2, 0), doubleArea(outline, 0, 1)];
            var axis:int = 0;
            for (i = 1; i < 3; i++)
            {
                if (Math.abs(normal[i]) > Math.abs(normal[axis]))
                {
                    axis = i;
                }
            }
            var turnsLeft:Boolean = normal[axis] > 0;
            _axisX = (axis + (turnsLeft ? 1 : 2)) % 3;
            _axisY = (axis + (turnsLeft ? 2 : 1)) % 3;
            return turnsLeft || normal[axis] < 0;
        }

        /**
         * Twice the area of a loop in the plane of two axes, positive if it turns left; in units of 1/scale squared.
         */
        private function doubleArea(loop:Vector.<uint>, axisX:int, axisY:int):Number
        {
            var originX:Number = _vertices[3 * loop[0] + axisX];
            var originY:Number = _vertices[3 * loop[0] + axisY];
            var lastX:Number = 0;
            var lastY:Number = 0;
            var area:Number = 0;
            for each (var corner:uint in loop)
            {
                var x:Number = (_vertices[3 * corner + axisX] - originX) * _scale;
                var y:Number = (_vertices[3 * corner + axisY] - originY) * _scale;
                area += lastX * y - lastY * x;
                lastX = x;
                lastY = y;
            }
            return area;
        }

        private function clear():void
        {
            _x.length = _y.length = _vertex.length = _next.length = _previous.length = 0;
        }

        /** Makes a ring of a loop, turned the way that is asked for; returns its first node. */
        private function addLoop(loop:Vector.<uint>, leftTurning:Boolean):int
        {
            var isTurned:Boolean = doubleArea(loop, _axisX, _axisY) > 0 != leftTurning;
            var first:int = _x.length;
            var count:int = loop.length;
            for (var i:int = 0; i < count; i++)
            {
                addNode(loop[isTurned ? count - 1 - i : i], first + (i + 1) % count, first + (i + count - 1) % count);
            }
            return first;
        }

        private function addNode(vertex:uint, next:int, previous:int):int
        {
            _x.push(_vertices[3 * vertex + _axisX] * _scale);
            _y.push(_vertices[3 * vertex + _axisY] * _scale);
            _vertex.push(vertex);
            _next.push(next);
            _previous.push(previous);
            return _x.length - 1;
        }

        /** Twice the area of the triangle of three nodes, positive if it turns left. */
        private function turn(a:int, b:int, c:int):Number
        {
            var x:Number = _x[a];
            var y:Number = _y[a];
            return (_x[b] - x) * (_y[c] - y) - (_y[b] - y) * (_x[c] - x);
        }

        /** Cuts the outline from its first corner if that sees all of it, as in every convex polygon. */
        private function addFan(count:int):Boolean
        {
            for (var i:int = 2; i < count; i++)
            {
                if (!(turn(0, i - 1, i) > 0))
                {
                    return false;
                }
            }
            for (i = 2; i < count; i++)
            {
                addTriangle(_vertex[0], _vertex[int(i - 1)], _vertex[i]);
            }
            return true;
        }

        /** The rightmost node of each hole, the holes that reach furthest right first. */
        private function holesFromTheRight(loops:Vector.<Vector.<uint>>):Array
        {
            var holes:Array = [];
            for (var i:int = 1; i < loops.length; i++)
            {
                if (loops[i].length > 2)
                {
                    holes.push(rightmost(addLoop(loops[i], false)));
                }
            }
            return holes.sort(compareByX);
        }

        private function compareByX(a:int, b:int):int
        {
            return _x[a] > _x[b] ? -1 : (_x[a] < _x[b] ? 1 : 0);
        }

        private function rightmost(start:int):int
        {
            var result:int = start;
            for (var node:int = _next[start]; node != start; node = _next[node])
            {
                if (_x[node] > _x[result])
                {
                    result = node;
                }
            }
            return result;
        }

        /** Opens the outline at a corner that sees the hole, and leads it round the hole and back. */
        private function addBridge(start:int, hole:int):void
        {
            var corner:int = visibleCorner(start, hole);
            if (corner < 0)
            {
                return; // the hole is not inside the outline
            }
            var holeEnd:int = addNode(_vertex[hole], -1, _previous[hole]);
            var cornerAgain:int = addNode(_vertex[corner], _next[corner], holeEnd);
            _next[holeEnd] = cornerAgain;
            _next[_previous[hole]] = holeEnd;
            _previous[_next[corner]] = cornerAgain;
            _next[corner] = hole;
            _previous[hole] = corner;
        }

        /** A corner of the outline that a hole's rightmost node sees, or -1. */
        private function visibleCorner(start:int, hole:int):int
        {
            var corner:int = -1;
            var nearest:Number = Number.POSITIVE_INFINITY;
            var x:Number = _x[hole];
            var y:Number = _y[hole];
            var node:int = start;
            do
            {
                if (++_work > MAX_WORK)
                {
                    return -1;
                }
                var end:int = _next[node];
                // the edge to the right that the hole is inside of goes upwards
                if (_y[node] <= y && y <= _y[end] && _y[node] < _y[end])
                {
                    var hit:Number = _x[node] + (y - _y[node]) * (_x[end] - _x[node]) / (_y[end] - _y[node]);
                    if (hit >= x && hit < nearest)
                    {
                        nearest = hit;
                        corner = _y[node] == y ? node : (_y[end] == y ? end : (_x[node] > _x[end] ? node : end));
                    }
                }
                node = end;
            }
            while (node != start);
            return corner < 0 || _y[corner] == y ? corner : nearestToRay(start, hole, nearest, corner);
        }

        /**
         * The corner that is in the way from a hole's node to another corner and lowest above the ray, or that
         * corner.
         */
        private function nearestToRay(start:int, hole:int, hitX:Number, corner:int):int
        {
            var x:Number = _x[hole];
            var y:Number = _y[hole];
            var isAbove:Boolean = _y[corner] > y;
            var ray:int = addNode(_vertex[hole], -1, -1);
            _x[ray] = hitX;
            var second:int = isAbove ? ray : corner;
            var third:int = isAbove ? corner : ray;
            var result:int = corner;
            var smallest:Number = Math.abs(_y[corner] - y) / (_x[corner] - x);
            var node:int = start;
            do
            {
                _work++;
                if (_x[node] > x && node != corner && isInside(node, hole, second, third) && seesInside(node, hole))
                {
                    var slope:Number = Math.abs(_y[node] - y) / (_x[node] - x);
                    if (slope < smallest || slope == smallest && _x[node] < _x[result])
                    {
                        smallest = slope;
                        result = node;
                    }
                }
                node = _next[node];
            }
            while (node != start);
            return result;
        }

        /** Whether the direction from a corner to another node goes into the polygon. */
        private function seesInside(corner:int, node:int):Boolean
        {
            var previous:int = _previous[corner];
            var next:int = _next[corner];
            if (turn(previous, corner, next) > 0)
            {
                return turn(corner, next, node) > 0 && turn(corner, node, previous) > 0;
            }
            return turn(corner, next, node) > 0 || turn(corner, node, previous) > 0;
        }

        private function isInside(node:int, a:int, b:int, c:int):Boolean
        {
            return turn(a, b, node) >= 0 && turn(b, c, node) >= 0 && turn(c, a, node) >= 0;
        }

        private function cutEars(start:int):void
        {
            var count:int = 1;
            for (var node:int = _next[start]; node != start; node = _next[node])
            {
                count++;
            }
            // an outline that crosses itself may have no ear left: after a round without one any left turn is cut,
            // after two any corner
            var misses:int = 0;
            while (count > 2)
            {
                var before:int = _previous[node];
                var after:int = _next[node];
                var area:Number = turn(before, node, after);
                var isCut:Boolean = area == 0 || misses > 2 * count || ++_work > MAX_WORK;
                if (isCut || area > 0 && (misses > count || isEar(before, node, after)))
                {
                    if (area > 0)
                    {
                        addTriangle(_vertex[before], _vertex[node], _vertex[after]);
                    }
                    _next[before] = after;
                    _previous[after] = before;
                    count--;
                    misses = misses > 2 * count ? misses : 0;
                    node = _next[after];
                }
                else
                {
                    misses++;
                    node = after;
                }
            }
        }

        /** Whether no other corner lies in a left turn's triangle. */
        private function isEar(before:int, tip:int, after:int):Boolean
        {
            var ax:Number = _x[before];
            var ay:Number = _y[before];
            var bx:Number = _x[tip];
            var by:Number = _y[tip];
            var cx:Number = _x[after];
            var cy:Number = _y[after];
            var minX:Number = Math.min(ax, bx, cx);
            var maxX:Number = Math.max(ax, bx, cx);
            var minY:Number = Math.min(ay, by, cy);
            var maxY:Number = Math.max(ay, by, cy);
            for (var node:int = _next[after]; node != before; node = _next[node])
            {
                _work++;
                var x:Number = _x[node];
                if (x < minX || x > maxX)
                {
                    continue;
                }
                var y:Number = _y[node];
                if (y < minY || y > maxY || x == ax && y == ay || x == bx && y == by || x == cx && y == cy)
                {
                    continue;
                }
                if (isInside(node, before, tip, after))
                {
                    return false;
                }
            }
            return true;
        }
    }
}
