package starlogo.models.polygons
{
    import starlogo.geometry.roundingOfProduct;
    import starlogo.models.files.FileBudget;

    /**
     * Triangulates a polygon with holes in a plane by ear clipping. A convex vertex, the tip, makes a triangle with its two neighbours. If no other
     * vertex is in the triangle, it is an ear, and is clipped off. Otherwise a diagonal inside the polygon connects the tip to a vertex in the triangle
     * (M. de Berg et al., "Computational Geometry", theorem 3.1). The diagonal splits the ring, or is a bridge to a hole.
     *
     * <p>The polygon is projected along the coordinate axis nearest to the outline's normal (by M. E. Newell's method), so that the outline is
     * counter-clockwise. Small bends out of the plane do no harm. Coordinates begin at the outline's first corner, are scaled by a power of two, and
     * are rounded to a grid, on which the directions of turns are exact. So a corner that is on a line stays there, and one that is beside it by
     * rounding is on the same side in each test.</p>
     *
     * <p>A corner may be in a ring more than once. So rings are made of nodes, and an index stands for a node. Node 0 is in the outline's ring.</p>
     */
    internal final class PolygonRings
    {
        /** The tests of corners in one step. */
        internal static const TESTS_PER_STEP:int = 10000;

        // Added to a coordinate from -1 to 1 and taken away again, it rounds the coordinate to a multiple of 2^-51.
        private static const ROUNDER:Number = 3;

        // The part of two products by which their computed difference may be wrong.
        private static const PRODUCTS_ROUNDING:Number = 4e-16;

        /** The projected coordinate of each node. The outline has a size of about 1: see unitScaleOf(). */
        internal var x:Vector.<Number> = new Vector.<Number>();
        internal var y:Vector.<Number> = new Vector.<Number>();

        /** The vertex of each node. */
        internal var vertex:Vector.<uint> = new Vector.<uint>();

        /** The next and the previous node in the ring, for each node. */
        internal var next:Vector.<int> = new Vector.<int>();
        internal var previous:Vector.<int> = new Vector.<int>();

        /** A node of the outline, and of each hole that is not joined to another ring. Read only. */
        internal var starts:Vector.<int> = new <int>[0];

        /** Limits the tests of corners. */
        internal var budget:FileBudget;

        // x, y, z of each vertex, and the vertex of the outline's first corner
        private var _vertices:Vector.<Number>;
        private var _origin:uint;

        // the indices of the two projected coordinates, which are equal if the outline has no area; and the scale that keeps their products finite
        private var _axisX:int;
        private var _axisY:int;
        private var _scale:Number;

        // A node of each ring that is not clipped yet. The last ring is next, from this node on.
        private var _unclipped:Vector.<int> = new <int>[0];

        /**
         * The plane of a polygon, and the outline's ring, which is counter-clockwise.
         *
         * @param budget limits the tests of corners
         * @param vertices x, y, z, ...; corners are indices of these
         * @param outline the corners of the outline
         */
        public function PolygonRings(budget:FileBudget, vertices:Vector.<Number>, outline:Vector.<uint>)
        {
            this.budget = budget;
            _vertices = vertices;
            _origin = outline[0];
            chooseAxis(outline);
            if (hasArea)
            {
                addLoop(outline, true);
            }
        }

        private function chooseAxis(outline:Vector.<uint>):void
        {
            _scale = unitScaleOf(_vertices, outline);
            var largest:Number = 0;
            for (var axis:int = 0; axis < 3; axis++)
            {
                var area:Number = doubleArea(outline, (axis + 1) % 3, (axis + 2) % 3);
                if (Math.abs(area) > Math.abs(largest))
                {
                    largest = area;
                    _axisX = (axis + (area > 0 ? 1 : 2)) % 3;
                    _axisY = (axis + (area > 0 ? 2 : 1)) % 3;
                }
            }
        }

        /** Whether the outline has an area. Otherwise there is no plane, and no ring. */
        internal function get hasArea():Boolean
        {
            return _axisX != _axisY;
        }

        /** Makes a clockwise ring from the corners of a hole, in either direction. */
        internal function addHole(corners:Vector.<uint>):void
        {
            starts.push(addLoop(corners, false));
        }

        private function addLoop(loop:Vector.<uint>, counterClockwise:Boolean):int
        {
            var isReversed:Boolean = doubleArea(loop, _axisX, _axisY) > 0 != counterClockwise;
            var first:int = x.length;
            var count:int = loop.length;
            for (var i:int = 0; i < count; i++)
            {
                var corner:uint = loop[isReversed ? count - 1 - i : i];
                addNode(corner, coordinateOf(corner, _axisX), coordinateOf(corner, _axisY), first + (i + 1) % count, first + (i + count - 1) % count);
            }
            return first;
        }

        /** Adds a copy of a node after a node, in the ring of that one. Returns its index. */
        internal function addCopy(node:int, before:int):int
        {
            var copy:int = addNode(vertex[node], x[node], y[node], next[before], before);
            previous[next[before]] = copy;
            next[before] = copy;
            return copy;
        }

        private function addNode(ofVertex:uint, atX:Number, atY:Number, nextNode:int, previousNode:int):int
        {
            x.push(atX);
            y.push(atY);
            vertex.push(ofVertex);
            next.push(nextNode);
            previous.push(previousNode);
            return x.length - 1;
        }

        private function coordinateOf(ofVertex:uint, axis:int):Number
        {
            var scaled:Number = (_vertices[3 * ofVertex + axis] - _vertices[3 * _origin + axis]) * _scale;
            return scaled + ROUNDER - ROUNDER;
        }

        // Whether two nodes have the same coordinates.
        private function areAtOnePlace(node:int, other:int):Boolean
        {
            return x[node] == x[other] && y[node] == y[other];
        }

        /** Twice the area of the triangle of three nodes; positive if it is counter-clockwise, with the exact sign. */
        internal function orient2d(a:int, b:int, c:int):Number
        {
            // differences on the grid are exact
            var toBX:Number = x[b] - x[a];
            var toBY:Number = y[b] - y[a];
            var toCX:Number = x[c] - x[a];
            var toCY:Number = y[c] - y[a];
            var left:Number = toBX * toCY;
            var right:Number = toBY * toCX;
            var area:Number = left - right;
            // products of 0 are exact, too
            if (Math.abs(area) > PRODUCTS_ROUNDING * (Math.abs(left) + Math.abs(right)) || left == 0 && right == 0)
            {
                return area;
            }
            return area + (roundingOfProduct(toBX, toCY, left) - roundingOfProduct(toBY, toCX, right));
        }

        /**
         * Clips some ears off the rings, in one step. Holes outside the outline are left out. Only triangles with an area are added. This holds
         * for corners in a straight line, and for rings that cross or cover themselves.
         *
         * @param triangles takes the ears
         * @return whether more is left
         */
        internal function clipEars(triangles:Vector.<uint>):Boolean
        {
            var end:Number = budget.cornerTestsLeft - TESTS_PER_STEP;
            while (_unclipped.length > 0 && budget.cornerTestsLeft > end)
            {
                var tip:int = clippableFrom(_unclipped.pop());
                var before:int = previous[tip];
                var after:int = next[tip];
                var isTipConvex:Boolean = isConvex(tip);
                if (before != after && !(isTipConvex && budget.cornerTestsLeft > 0 && addDiagonal(tip)))
                {
                    if (isTipConvex)
                    {
                        triangles.push(vertex[before], vertex[tip], vertex[after]);
                    }
                    next[before] = after;
                    previous[after] = before;
                    // A neighbour where the ring now turns back comes first, because no other ear is right before it is gone. Ears are less thin if
                    // their tips do not follow one another.
                    _unclipped.push(turnsBack(before) ? before : (turnsBack(after) || !isConvex(next[after]) ? after : next[after]));
                }
            }
            return _unclipped.length > 0;
        }

        // The next node, from a given one on, that is convex or turns back. If there is none, or no tests are left, it is another node.
        private function clippableFrom(first:int):int
        {
            var node:int = first;
            do
            {
                budget.spendCornerTests(1);
                if (isConvex(node) || turnsBack(node))
                {
                    return node;
                }
                node = next[node];
            }
            while (node != first && budget.cornerTestsLeft > 0);
            return node;
        }

        // Adds the diagonal from a convex node to a node in its triangle, as an edge there and an edge back. Returns false if the triangle is an ear.
        private function addDiagonal(tip:int):Boolean
        {
            var hole:int = 0;
            var nearest:int = -1;
            for (var i:int = 0; i < starts.length; i++)
            {
                var nearer:int = diagonalEnd(tip, i == 0 ? tip : starts[i], nearest);
                if (nearer != nearest)
                {
                    nearest = nearer;
                    hole = i;
                }
            }
            if (nearest < 0)
            {
                return false;
            }
            var tipCopy:int = addCopy(tip, tip);
            var endCopy:int = addCopy(nearest, previous[nearest]);
            next[tip] = nearest;
            previous[nearest] = tip;
            next[endCopy] = tipCopy;
            previous[tipCopy] = endCopy;
            if (hole == 0)
            {
                _unclipped.push(tipCopy);
            }
            else
            {
                starts.splice(hole, 1);
            }
            _unclipped.push(tip);
            return true;
        }

        // The other end of a diagonal from a convex tip: the first node that the side before the tip meets if it turns about its start into the triangle.
        // So no edge hides this node from the tip. Compares the nodes of one ring, and the node found in the rings before (-1 for none).
        private function diagonalEnd(tip:int, start:int, found:int):int
        {
            var before:int = previous[tip];
            var after:int = next[tip];
            var minX:Number = Math.min(x[before], x[tip], x[after]);
            var maxX:Number = Math.max(x[before], x[tip], x[after]);
            var nearest:int = found;
            var count:int = 0;
            var node:int = start;
            do
            {
                // most corners are beside the triangle
                if (x[node] >= minX && x[node] <= maxX && isDiagonalEnd(node, before, tip, after))
                {
                    var turn:Number = nearest < 0 ? 1 : orient2d(before, node, nearest);
                    nearest = turn > 0 || turn == 0 && distance(before, node) < distance(before, nearest) ? node : nearest;
                }
                count++;
                node = next[node];
            }
            while (node != start);
            budget.spendCornerTests(count);
            return nearest;
        }

        // Of nodes in one direction, the lower distance is that of the nearer one.
        private function distance(from:int, to:int):Number
        {
            return Math.abs(x[to] - x[from]) + Math.abs(y[to] - y[from]);
        }

        // Whether a node is in the triangle of a convex tip, and the diagonal from it to the tip begins inside the polygon. A node at the tip's place
        // counts if its ring enters the triangle.
        private function isDiagonalEnd(node:int, before:int, tip:int, after:int):Boolean
        {
            // most corners are beyond the third side
            if (orient2d(after, before, node) < 0 || areAtOnePlace(node, before) || areAtOnePlace(node, after))
            {
                return false;
            }
            return areAtOnePlace(node, tip) ? entersCone(node, before, tip, after)
                : orient2d(before, tip, node) >= 0 && orient2d(tip, after, node) >= 0 && isLocallyInside(node, tip);
        }

        // Whether the line from a node to another one begins inside the polygon, which is left of each edge. At a convex node the line must be left of
        // both edges. At a reflex node it must be left of one of them.
        private function isLocallyInside(node:int, other:int):Boolean
        {
            var isLeftOfNext:Boolean = orient2d(node, next[node], other) > 0;
            var isLeftOfPrevious:Boolean = orient2d(previous[node], node, other) > 0;
            return isConvex(node) ? isLeftOfPrevious && isLeftOfNext : isLeftOfPrevious || isLeftOfNext;
        }

        private function isConvex(node:int):Boolean
        {
            return orient2d(previous[node], node, next[node]) > 0;
        }

        // Whether the ring turns around at a node, as at the end of a spike, or the node is at the same place as a neighbour.
        private function turnsBack(node:int):Boolean
        {
            var before:int = previous[node];
            var after:int = next[node];
            return (x[before] - x[node]) * (x[after] - x[node]) + (y[before] - y[node]) * (y[after] - y[node]) >= 0 && orient2d(before, node, after) == 0;
        }

        // Whether the ring of a node at a convex tip's place has an edge in the tip's cone, or has its edges along both sides of it, as a hole that
        // fills the corner. The ends of the edges may be beyond the triangle.
        private function entersCone(node:int, before:int, tip:int, after:int):Boolean
        {
            var from:int = previous[node];
            var to:int = next[node];
            return isInCone(from, before, tip, after) || isInCone(to, before, tip, after)
                || orient2d(tip, after, from) == 0 && orient2d(before, tip, from) > 0 && orient2d(before, tip, to) == 0 && orient2d(tip, after, to) > 0;
        }

        // Whether a node is in the cone of a convex tip: between its two sides, however long these are.
        private function isInCone(node:int, before:int, tip:int, after:int):Boolean
        {
            return orient2d(before, tip, node) > 0 && orient2d(tip, after, node) > 0;
        }

        // Twice the area of a loop in the plane of two axes; positive if it is counter-clockwise. Its coordinates are scaled.
        private function doubleArea(loop:Vector.<uint>, axisX:int, axisY:int):Number
        {
            var originX:Number = _vertices[3 * loop[0] + axisX];
            var originY:Number = _vertices[3 * loop[0] + axisY];
            var lastX:Number = 0;
            var lastY:Number = 0;
            var area:Number = 0;
            for each (var corner:uint in loop)
            {
                var cornerX:Number = (_vertices[3 * corner + axisX] - originX) * _scale;
                var cornerY:Number = (_vertices[3 * corner + axisY] - originY) * _scale;
                area += lastX * cornerY - lastY * cornerX;
                lastX = cornerX;
                lastY = cornerY;
            }
            return area;
        }
    }
}
