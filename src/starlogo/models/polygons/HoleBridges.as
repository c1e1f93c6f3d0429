package starlogo.models.polygons
{
    import starlogo.models.FileLimits;

    /**
     * Joins each hole of a polygon to the outline by a bridge, so that one ring is left (D. Eberly, "Triangulation by Ear Clipping", 2002).
     */
    internal final class HoleBridges
    {
        private var _rings:PolygonRings;
        private var _outline:int;

        // the rightmost node of each hole; the last one is joined next
        private var _nodes:Array = [];

        /**
         * @param rings contains the rings
         * @param outline a node of the outline's ring
         * @param holes a node of each hole's ring; these rings are clockwise
         */
        public function HoleBridges(rings:PolygonRings, outline:int, holes:Vector.<int>)
        {
            _rings = rings;
            _outline = outline;
            for each (var hole:int in holes)
            {
                _nodes.push(rightmost(hole));
            }
            // The hole that reaches furthest right is joined first. So no bridge crosses another hole.
            _nodes.sort(compareByX);
        }

        /** Joins holes until none is left, or for one step. Holes outside the outline are left out. Returns whether holes are left. */
        internal function join():Boolean
        {
            var limits:FileLimits = _rings.limits;
            var end:Number = limits.cornerTestsLeft - PolygonRings.TESTS_PER_STEP;
            while (_nodes.length > 0 && limits.cornerTestsLeft > end)
            {
                addBridge(_nodes.pop());
            }
            return _nodes.length > 0;
        }

        // If two nodes have the same x, the first in the file comes first, in every player.
        private function compareByX(a:int, b:int):int
        {
            var x:Vector.<Number> = _rings.x;
            return x[a] > x[b] ? 1 : (x[a] < x[b] ? -1 : b - a);
        }

        private function rightmost(start:int):int
        {
            var result:int = start;
            for (var node:int = _rings.next[start]; node != start; node = _rings.next[node])
            {
                if (_rings.x[node] > _rings.x[result])
                {
                    result = node;
                }
            }
            return result;
        }

        // Joins a hole to a corner of the outline that sees it.
        private function addBridge(hole:int):void
        {
            if (_rings.limits.cornerTestsLeft <= 0)
            {
                return;
            }
            // the search goes around the outline three times
            _rings.limits.countCornerTests(3 * _rings.countFrom(_outline));
            var corner:int = visibleCorner(hole);
            // without one, the hole is not inside the outline
            if (corner >= 0)
            {
                _rings.join(nodeThatSees(corner, hole), hole);
            }
        }

        // A corner of the outline that is visible from a hole's rightmost node, or -1.
        private function visibleCorner(hole:int):int
        {
            var xs:Vector.<Number> = _rings.x;
            var ys:Vector.<Number> = _rings.y;
            var corner:int = -1;
            var nearest:Number = Number.POSITIVE_INFINITY;
            var x:Number = xs[hole];
            var y:Number = ys[hole];
            var node:int = _outline;
            do
            {
                var end:int = _rings.next[node];
                // the outline is counter-clockwise, so the edge to the right of an inner point goes upwards
                if (ys[node] <= y && y <= ys[end] && ys[node] < ys[end])
                {
                    var hit:Number = xs[node] + (y - ys[node]) * (xs[end] - xs[node]) / (ys[end] - ys[node]);
                    if (hit >= x && hit < nearest)
                    {
                        nearest = hit;
                        corner = ys[node] == y ? node : (ys[end] == y ? end : (xs[node] > xs[end] ? node : end));
                    }
                }
                node = end;
            }
            while (node != _outline);
            return corner < 0 || ys[corner] == y ? corner : nearestToRay(hole, nearest, corner);
        }

        // The corner that is visible from a hole's node. It is the given corner, unless others block the line to it. Then it is the blocking corner
        // nearest to the ray, which meets the outline at hitX.
        private function nearestToRay(hole:int, hitX:Number, corner:int):int
        {
            var xs:Vector.<Number> = _rings.x;
            var ys:Vector.<Number> = _rings.y;
            var x:Number = xs[hole];
            var y:Number = ys[hole];
            var result:int = corner;
            var smallest:Number = Math.abs(ys[corner] - y) / (xs[corner] - x);
            var node:int = _outline;
            do
            {
                if (xs[node] > x && node != corner && isBetween(node, hole, hitX, corner) && seesInside(node, hole))
                {
                    var slope:Number = Math.abs(ys[node] - y) / (xs[node] - x);
                    if (slope < smallest || slope == smallest && xs[node] < xs[result])
                    {
                        smallest = slope;
                        result = node;
                    }
                }
                node = _rings.next[node];
            }
            while (node != _outline);
            return result;
        }

        // Whether a node is inside the triangle of a hole's node, the place where its ray meets the outline, and a corner, or on its edge.
        private function isBetween(node:int, hole:int, hitX:Number, corner:int):Boolean
        {
            var holeY:Number = _rings.y[hole];
            var upToCorner:Number = _rings.y[corner] - holeY;
            var up:Number = _rings.y[node] - holeY;
            // counter-clockwise, the triangle goes along the ray first if the corner is above it
            var direction:int = upToCorner > 0 ? 1 : -1;
            var leftOfOutline:Number = (_rings.x[corner] - hitX) * up - upToCorner * (_rings.x[node] - hitX);
            return direction * up >= 0 && direction * leftOfOutline >= 0 && direction * _rings.orient2d(corner, hole, node) >= 0;
        }

        // A corner where bridges begin is in the ring several times. Returns the node at its place that has the hole's node on its side of the bridges.
        private function nodeThatSees(corner:int, hole:int):int
        {
            var node:int = corner;
            do
            {
                if (_rings.x[node] == _rings.x[corner] && _rings.y[node] == _rings.y[corner] && seesInside(node, hole))
                {
                    return node;
                }
                node = _rings.next[node];
            }
            while (node != corner);
            return corner;
        }

        // Whether the direction from a corner to another node goes into the polygon.
        private function seesInside(corner:int, node:int):Boolean
        {
            var previous:int = _rings.previous[corner];
            var next:int = _rings.next[corner];
            if (_rings.orient2d(previous, corner, next) > 0)
            {
                return _rings.orient2d(corner, next, node) > 0 && _rings.orient2d(corner, node, previous) > 0;
            }
            return _rings.orient2d(corner, next, node) > 0 || _rings.orient2d(corner, node, previous) > 0;
        }
    }
}
