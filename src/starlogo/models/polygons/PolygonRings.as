package starlogo.models.polygons
{
    import starlogo.geometry.roundingOfProduct;
    import starlogo.models.files.FileBudget;

    /**
     * A polygon's outline and holes as rings of corners in a plane, which it cuts into triangles. If no other corner is in the triangle at a corner
     * that turns left, this triangle is cut off. Otherwise the corner is connected to one in the triangle, by a diagonal inside the polygon (M. de
     * Berg et al., "Computational Geometry", theorem 3.1). This divides the ring, or joins a hole to it.
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

        // A node of each ring that is to be cut. The last ring is being cut, from this node on.
        private var _uncut:Vector.<int> = new <int>[0];

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
         * Does a step that cuts the rings into triangles. Holes outside the outline are left out. Only triangles with an area are added. This holds
         * for corners in a straight line, and for rings that cross or cover themselves.
         *
         * @param triangles takes the triangles
         * @return whether more is to be cut
         */
        internal function cut(triangles:Vector.<uint>):Boolean
        {
            var end:Number = budget.cornerTestsLeft - TESTS_PER_STEP;
            while (_uncut.length > 0 && budget.cornerTestsLeft > end)
            {
                var tip:int = cuttableFrom(_uncut.pop());
                var before:int = previous[tip];
                var after:int = next[tip];
                var isLeftTurn:Boolean = turnsLeft(tip);
                if (before != after && !(isLeftTurn && budget.cornerTestsLeft > 0 && connect(tip)))
                {
                    if (isLeftTurn)
                    {
                        triangles.push(vertex[before], vertex[tip], vertex[after]);
                    }
                    next[before] = after;
                    previous[after] = before;
                    // What is left of a cut part goes first, because no other triangle is right while the ring goes there and back. Triangles are less thin
                    // if their tips do not follow one another.
                    _uncut.push(turnsBack(before) ? before : (turnsBack(after) || !turnsLeft(next[after]) ? after : next[after]));
                }
            }
            return _uncut.length > 0;
        }

        // The first node, from a given one on, at which the ring turns left or goes back. If there is none, as in a ring that crosses itself, or no
        // tests are left, it is another node.
        private function cuttableFrom(first:int):int
        {
            var node:int = first;
            do
            {
                budget.spendCornerTests(1);
                if (turnsLeft(node) || turnsBack(node))
                {
                    return node;
                }
                node = next[node];
            }
            while (node != first && budget.cornerTestsLeft > 0);
            return node;
        }

        // Connects a left turn to the nearest node in its triangle, and back. Returns whether there is one.
        private function connect(tip:int):Boolean
        {
            var hole:int = 0;
            var nearest:int = -1;
            for (var i:int = 0; i < starts.length; i++)
            {
                var nearer:int = nearestInTriangle(tip, i == 0 ? tip : starts[i], nearest);
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
            var tipAgain:int = addCopy(tip, tip);
            var nearestAgain:int = addCopy(nearest, previous[nearest]);
            next[tip] = nearest;
            previous[nearest] = tip;
            next[nearestAgain] = tipAgain;
            previous[tipAgain] = nearestAgain;
            if (hole == 0)
            {
                _uncut.push(tipAgain);
            }
            else
            {
                starts.splice(hole, 1);
            }
            _uncut.push(tip);
            return true;
        }

        // The node in the triangle of a left turn that is nearest to the side before the tip, by the angle at this side's start. So no edge is between the
        // tip and this node. It looks at the nodes of a ring, and at the node found before (-1 for none).
        private function nearestInTriangle(tip:int, start:int, found:int):int
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
                if (x[node] >= minX && x[node] <= maxX && isInTriangle(node, before, tip, after))
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

        // Whether a node is in the triangle of a left turn, and a line from it to the tip begins inside the polygon. If it is at the tip, whether its ring
        // goes into the triangle.
        private function isInTriangle(node:int, before:int, tip:int, after:int):Boolean
        {
            // most corners are beyond the third side
            if (orient2d(after, before, node) < 0 || areAtOnePlace(node, before) || areAtOnePlace(node, after))
            {
                return false;
            }
            return areAtOnePlace(node, tip) ? goesInto(node, before, tip, after)
                : orient2d(before, tip, node) >= 0 && orient2d(tip, after, node) >= 0 && isLocallyInside(node, tip);
        }

        // Whether a line from a node to another one begins inside the polygon.
        private function isLocallyInside(node:int, other:int):Boolean
        {
            var isAfterNext:Boolean = orient2d(node, next[node], other) > 0;
            var isBeforePrevious:Boolean = orient2d(node, other, previous[node]) > 0;
            return orient2d(node, next[node], previous[node]) > 0 ? isAfterNext && isBeforePrevious : isAfterNext || isBeforePrevious;
        }

        private function turnsLeft(node:int):Boolean
        {
            return orient2d(previous[node], node, next[node]) > 0;
        }

        // Whether the ring goes back at a node the way it came, or stays in its place.
        private function turnsBack(node:int):Boolean
        {
            var before:int = previous[node];
            var after:int = next[node];
            return (x[before] - x[node]) * (x[after] - x[node]) + (y[before] - y[node]) * (y[after] - y[node]) >= 0 && orient2d(before, node, after) == 0;
        }

        // Whether the ring of a node at the tip's place goes into the triangle of a left turn there, or comes along one side and leaves along the other, as
        // a hole that fills the corner. The ends of its edges may be beyond the triangle.
        private function goesInto(node:int, before:int, tip:int, after:int):Boolean
        {
            var from:int = previous[node];
            var to:int = next[node];
            return isInCorner(from, before, tip, after) || isInCorner(to, before, tip, after)
                || orient2d(tip, after, from) == 0 && orient2d(before, tip, from) > 0 && orient2d(before, tip, to) == 0 && orient2d(tip, after, to) > 0;
        }

        // Whether a node is between the two sides of a left turn, or of what goes on beyond them.
        private function isInCorner(node:int, before:int, tip:int, after:int):Boolean
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
