package starlogo.models.polygons
{
    import starlogo.geometry.roundingOfProduct;
    import starlogo.models.files.FileBudget;

    /**
     * A polygon's outline and holes as rings of corners in a plane. Once the holes are joined to the outline (HoleBridges), that ring is cut into
     * triangles, one ear at a time. The polygon is projected along the coordinate axis nearest to the outline's normal (by M. E. Newell's method),
     * so that the outline is counter-clockwise. Small bends out of the plane do no harm.
     * Coordinates begin at the outline's first corner, are scaled by a power of two, and are rounded to a grid, on which the directions of turns are
     * exact. So a corner that is on a line stays there, and one that is beside it by rounding is on the same side in each test.
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

        /** The next node in the ring, for each node. */
        internal var next:Vector.<int> = new Vector.<int>();

        /** The previous node in the ring, for each node. */
        internal var previous:Vector.<int> = new Vector.<int>();

        /** Limit the tests of corners. */
        internal var budget:FileBudget;

        // x, y, z of each vertex, and the vertex of the outline's first corner
        private var _vertices:Vector.<Number>;
        private var _origin:uint;

        // the indices of the two projected coordinates, which are equal if the outline has no area; and the scale that keeps their products finite
        private var _axisX:int;
        private var _axisY:int;
        private var _scale:Number;

        // while ears are cut: the present node, the number of corners left, and the number of corners passed since the last ear
        private var _node:int = 0;
        private var _count:int = 0;
        private var _misses:int = 0;

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

        /** Makes a clockwise ring from the corners of a hole, in either direction. Returns its first node. */
        internal function addHole(corners:Vector.<uint>):int
        {
            return addLoop(corners, false);
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

        /** Opens a ring at a corner. It then goes to a node of another ring, around that, and back. */
        internal function bridge(corner:int, other:int):void
        {
            var cornerAgain:int = addCopy(corner, corner);
            var otherEnd:int = addCopy(other, previous[other]);
            next[corner] = other;
            previous[other] = corner;
            next[otherEnd] = cornerAgain;
            previous[cornerAgain] = otherEnd;
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

        /** Whether two nodes have the same coordinates. */
        internal function areAtOnePlace(node:int, other:int):Boolean
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
            if (Math.abs(area) > PRODUCTS_ROUNDING * (Math.abs(left) + Math.abs(right)))
            {
                return area;
            }
            return area + (roundingOfProduct(toBX, toCY, left) - roundingOfProduct(toBY, toCX, right));
        }

        /**
         * Does a step that cuts the outline's ring into triangles. Only triangles with an area are added. This holds for corners in a straight line,
         * and for rings that cross or cover themselves. It ends for every ring, because any corner is cut off after two rounds without an ear.
         *
         * @param triangles takes the triangles
         * @return whether more than two corners are left
         */
        internal function cutEars(triangles:Vector.<uint>):Boolean
        {
            var end:Number = budget.cornerTestsLeft - TESTS_PER_STEP;
            _count ||= countOutline();
            while (_count > 2 && budget.cornerTestsLeft > end)
            {
                var before:int = previous[_node];
                var after:int = next[_node];
                var area:Number = orient2d(before, _node, after);
                // An outline that crosses itself may have no ear left. After one round without an ear any left turn is cut, after two
                // rounds any corner.
                var cutsLeftTurns:Boolean = _misses > _count;
                var cutsAll:Boolean = _misses > 2 * _count || budget.cornerTestsLeft <= 0;
                budget.spendCornerTests(1);
                if (cutsAll || area == 0 || area > 0 && (cutsLeftTurns || isEar(before, _node, after)))
                {
                    if (area > 0)
                    {
                        triangles.push(vertex[before], vertex[_node], vertex[after]);
                    }
                    next[before] = after;
                    previous[after] = before;
                    // once all are cut, it stays so
                    _misses = cutsAll ? _misses : 0;
                    _count--;
                    // What is left of a cut part goes first, because no other triangle is right while the ring goes there and back.
                    _node = turnsBack(before) ? before : (turnsBack(after) ? after : next[after]);
                }
                else
                {
                    _misses++;
                    _node = after;
                }
            }
            return _count > 2;
        }

        // The number of nodes in the outline's ring.
        private function countOutline():int
        {
            var count:int = 1;
            for (var node:int = next[0]; node != 0; node = next[node])
            {
                count++;
            }
            return count;
        }

        // Whether no other corner is in the triangle of a left turn.
        private function isEar(before:int, tip:int, after:int):Boolean
        {
            var minX:Number = Math.min(x[before], x[tip], x[after]);
            var maxX:Number = Math.max(x[before], x[tip], x[after]);
            var outside:int = 0;
            var node:int = next[after];
            // most corners are beside the triangle
            while (node != before && !(x[node] >= minX && x[node] <= maxX && isInWay(node, before, tip, after)))
            {
                outside++;
                node = next[node];
            }
            budget.spendCornerTests(outside);
            return node == before;
        }

        private function isInWay(node:int, before:int, tip:int, after:int):Boolean
        {
            var isAtEnd:Boolean = areAtOnePlace(node, before) || areAtOnePlace(node, after);
            return !isAtEnd && (areAtOnePlace(node, tip) ? goesInto(node, before, tip, after) : isInside(node, before, tip, after));
        }

        // Whether the ring goes back at a node the way it came, or stays in its place.
        private function turnsBack(node:int):Boolean
        {
            var before:int = previous[node];
            var after:int = next[node];
            return orient2d(before, node, after) == 0 && (x[before] - x[node]) * (x[after] - x[node]) + (y[before] - y[node]) * (y[after] - y[node]) >= 0;
        }

        // Whether the triangle of three nodes in a row has another node inside it or on its edge. The triangle must be counter-clockwise. A node
        // that touches one of its two sides in the ring from outside does not count.
        private function isInside(node:int, before:int, tip:int, after:int):Boolean
        {
            var left:Number = orient2d(before, tip, node);
            var right:Number = left < 0 ? -1 : orient2d(tip, after, node);
            return right >= 0 && orient2d(after, before, node) >= 0
                && !(left == 0 && isBeyond(node, before, tip)) && !(right == 0 && isBeyond(node, tip, after));
        }

        // Whether the ring goes at a node at the tip's place into the triangle of three nodes in a row, which must be counter-clockwise, or leaves it
        // out. The ends of its edges may be beyond the triangle: where a hole touches the tip, the ring goes there and back.
        private function goesInto(node:int, before:int, tip:int, after:int):Boolean
        {
            return isInCorner(previous[node], before, tip, after) || isInCorner(next[node], before, tip, after)
                || isAlongSides(previous[node], next[node], before, tip, after);
        }

        // Whether a node is in the direction of the side after a left turn, and another one in the direction of the side before it.
        private function isAlongSides(alongAfter:int, alongBefore:int, before:int, tip:int, after:int):Boolean
        {
            return orient2d(tip, after, alongAfter) == 0 && orient2d(before, tip, alongAfter) > 0
                && orient2d(before, tip, alongBefore) == 0 && orient2d(tip, after, alongBefore) > 0;
        }

        // Whether a node is between the two sides of a left turn, or of what goes on beyond them.
        private function isInCorner(node:int, before:int, tip:int, after:int):Boolean
        {
            return orient2d(before, tip, node) > 0 && orient2d(tip, after, node) > 0;
        }

        // Whether no edge at a node goes to the left of a line.
        private function isBeyond(node:int, from:int, to:int):Boolean
        {
            return orient2d(from, to, previous[node]) <= 0 && orient2d(from, to, next[node]) <= 0;
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
