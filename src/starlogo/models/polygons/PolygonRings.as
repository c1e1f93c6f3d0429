package starlogo.models.polygons
{
    import starlogo.models.FileLimits;

    /**
     * A polygon's outline and holes as rings of corners in a plane. The polygon is projected along the coordinate axis nearest to the
     * outline's normal (by M. E. Newell's method), so that the outline is counter-clockwise. Small bends out of the plane do no harm.
     *
     * <p>A corner may be in a ring more than once. So rings are made of nodes, and an index stands for a node.</p>
     */
    internal final class PolygonRings
    {
        /** The tests of corners in one step. */
        internal static const TESTS_PER_STEP:int = 10000;

        /** The projected coordinate of each node, scaled so that the outline has a size of about 1. */
        internal var x:Vector.<Number> = new Vector.<Number>();
        internal var y:Vector.<Number> = new Vector.<Number>();

        /** The vertex of each node. */
        internal var vertex:Vector.<uint> = new Vector.<uint>();

        /** The next node in the ring, for each node. */
        internal var next:Vector.<int> = new Vector.<int>();

        /** The previous node in the ring, for each node. */
        internal var previous:Vector.<int> = new Vector.<int>();

        /** Limit the tests of corners. */
        internal var limits:FileLimits;

        /** Whether the outline has an area. Otherwise there is no axis of projection, and no ring. */
        internal var hasArea:Boolean = false;

        // x, y, z of each vertex
        private var _vertices:Vector.<Number>;

        // the indices of the two projected coordinates, and the scale that keeps their products finite
        private var _axisX:int;
        private var _axisY:int;
        private var _scale:Number;

        /**
         * Chooses the axis of projection. There are no rings yet.
         *
         * @param limits limit the tests of corners
         * @param vertices x, y, z, ...; corners are indices of these
         * @param outline the corners of the outline
         */
        public function PolygonRings(limits:FileLimits, vertices:Vector.<Number>, outline:Vector.<uint>)
        {
            this.limits = limits;
            _vertices = vertices;
            _scale = 1 / extentOf(outline);
            if (!(_scale > 0 && _scale < Number.POSITIVE_INFINITY))
            {
                return;
            }
            var normal:Vector.<Number> = new <Number>[
                    doubleArea(outline, 1, 2), doubleArea(outline, 2, 0), doubleArea(outline, 0, 1)];
            var axis:int = 0;
            for (var i:int = 1; i < 3; i++)
            {
                if (Math.abs(normal[i]) > Math.abs(normal[axis]))
                {
                    axis = i;
                }
            }
            var turnsLeft:Boolean = normal[axis] > 0;
            _axisX = (axis + (turnsLeft ? 1 : 2)) % 3;
            _axisY = (axis + (turnsLeft ? 2 : 1)) % 3;
            hasArea = normal[axis] != 0;
        }

        /**
         * Makes a ring from a loop of corners.
         *
         * @param loop the corners, in either direction
         * @param counterClockwise whether the ring is to be counter-clockwise
         * @return its first node
         */
        internal function addLoop(loop:Vector.<uint>, counterClockwise:Boolean):int
        {
            var isReversed:Boolean = doubleArea(loop, _axisX, _axisY) > 0 != counterClockwise;
            var first:int = x.length;
            var count:int = loop.length;
            for (var i:int = 0; i < count; i++)
            {
                addNode(loop[isReversed ? count - 1 - i : i], first + (i + 1) % count, first + (i + count - 1) % count);
            }
            return first;
        }

        /** Opens a ring at a corner. It then goes to a node of another ring, around that, and back. */
        internal function join(corner:int, other:int):void
        {
            var otherEnd:int = addNode(vertex[other], -1, previous[other]);
            var cornerAgain:int = addNode(vertex[corner], next[corner], otherEnd);
            next[otherEnd] = cornerAgain;
            next[previous[other]] = otherEnd;
            previous[next[corner]] = cornerAgain;
            next[corner] = other;
            previous[other] = corner;
        }

        // Adds a node for a vertex and returns its index.
        private function addNode(ofVertex:uint, nextNode:int, previousNode:int):int
        {
            x.push(_vertices[3 * ofVertex + _axisX] * _scale);
            y.push(_vertices[3 * ofVertex + _axisY] * _scale);
            vertex.push(ofVertex);
            next.push(nextNode);
            previous.push(previousNode);
            return x.length - 1;
        }

        /** Takes a node out of its ring. */
        internal function remove(node:int):void
        {
            var before:int = previous[node];
            var after:int = next[node];
            next[before] = after;
            previous[after] = before;
        }

        /** The number of nodes in the ring of a node. */
        internal function countFrom(node:int):int
        {
            var count:int = 1;
            for (var i:int = next[node]; i != node; i = next[i])
            {
                count++;
            }
            return count;
        }

        /** Twice the area of the triangle of three nodes; positive if it is counter-clockwise. */
        internal function orient2d(a:int, b:int, c:int):Number
        {
            var ax:Number = x[a];
            var ay:Number = y[a];
            return (x[b] - ax) * (y[c] - ay) - (y[b] - ay) * (x[c] - ax);
        }

        /** Whether a node is inside a triangle of three other nodes or on its edge. The triangle must be counter-clockwise. */
        internal function isInside(node:int, a:int, b:int, c:int):Boolean
        {
            return orient2d(a, b, node) >= 0 && orient2d(b, c, node) >= 0 && orient2d(c, a, node) >= 0;
        }

        private function extentOf(loop:Vector.<uint>):Number
        {
            var origin:int = 3 * loop[0];
            var extent:Number = 0;
            for each (var corner:uint in loop)
            {
                for (var i:int = 0; i < 3; i++)
                {
                    extent = Math.max(extent, Math.abs(_vertices[3 * corner + i] - _vertices[origin + i]));
                }
            }
            return extent;
        }

        // Twice the area of a loop in the plane of two axes; positive if it is counter-clockwise. The unit is 1/scale squared.
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
