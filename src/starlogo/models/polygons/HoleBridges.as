package starlogo.models.polygons
{
    import starlogo.models.files.FileBudget;
    import starlogo.steps.Steps;

    /**
     * Joins each hole of a polygon to the outline by a bridge, so that one ring is left (D. Eberly, "Triangulation by Ear Clipping", 2002). If a
     * hole touches the outline or another hole, both get a corner there.
     */
    internal final class HoleBridges implements Steps
    {
        // Corners touch what they are closer to. The outline has a size of about 1. Files round to seven digits.
        private static const TOUCH_DISTANCE:Number = 1e-6;

        private var _rings:PolygonRings;

        // the rightmost node of each hole; the last one is joined next
        private var _nodes:Array = [];

        // the node of the outline to whose edge that hole is welded next; 0 before the first edge and after the last one
        private var _edge:int = 0;

        /**
         * @param rings contains the rings
         * @param holes a node of each hole's ring
         */
        public function HoleBridges(rings:PolygonRings, holes:Vector.<int>)
        {
            _rings = rings;
            for each (var hole:int in holes)
            {
                _nodes.push(rightmost(hole));
            }
            // The hole that reaches furthest right is joined first. So no bridge crosses another hole.
            _nodes.sort(compareByX);
        }

        /** @inheritDoc Joins holes until none is left, or for one step. Holes outside the outline are left out. */
        public function step():Boolean
        {
            var budget:FileBudget = _rings.budget;
            var end:Number = budget.cornerTestsLeft - PolygonRings.TESTS_PER_STEP;
            while (_nodes.length > 0 && budget.cornerTestsLeft > end)
            {
                weld(_nodes[int(_nodes.length - 1)], Math.max(end, 0));
                if (budget.cornerTestsLeft <= 0)
                {
                    _nodes.length = 0;
                }
                else if (_edge == 0)
                {
                    addHole(rightmost(_nodes.pop()));
                }
            }
            return _nodes.length > 0;
        }

        // If two nodes have the same x, the first in the file comes first, in every player.
        private function compareByX(a:int, b:int):int
        {
            var x:Vector.<Number> = _rings.x;
            return x[a] > x[b] ? 1 : (x[a] < x[b] ? -1 : b - a);
        }

        // The rightmost node of a ring; of several the lowest.
        private function rightmost(start:int):int
        {
            var xs:Vector.<Number> = _rings.x;
            var result:int = start;
            for (var node:int = _rings.next[start]; node != start; node = _rings.next[node])
            {
                if (xs[node] > xs[result] || xs[node] == xs[result] && _rings.y[node] < _rings.y[result])
                {
                    result = node;
                }
            }
            return result;
        }

        // Joins a hole by a bridge from its rightmost node to a corner of the outline that is at its place, or sees it.
        private function addHole(hole:int):void
        {
            var node:int = atOrRightOf(hole);
            // without one, the hole is not inside the outline
            if (node >= 0)
            {
                _rings.bridge(nodeThatSees(_rings.areAtOnePlace(node, hole) ? node : visibleCorner(hole, node), hole), hole);
            }
        }

        // Where a hole touches the outline, gives both a corner at one place. So a touch counts also if rounding has put it inside or outside. Goes on
        // until the edges are done, or as few tests are left as are given.
        private function weld(hole:int, testsLeft:Number):void
        {
            var xs:Vector.<Number> = _rings.x;
            var ys:Vector.<Number> = _rings.y;
            var minX:Number = Number.POSITIVE_INFINITY;
            var minY:Number = minX;
            var maxX:Number = -minX;
            var maxY:Number = -minX;
            var corner:int = hole;
            do
            {
                minX = Math.min(minX, xs[corner] - TOUCH_DISTANCE);
                minY = Math.min(minY, ys[corner] - TOUCH_DISTANCE);
                maxX = Math.max(maxX, xs[corner] + TOUCH_DISTANCE);
                maxY = Math.max(maxY, ys[corner] + TOUCH_DISTANCE);
                corner = _rings.next[corner];
            }
            while (corner != hole);
            do
            {
                // the search for a bridge goes around the outline three times
                var tests:int = 3;
                var end:int = _rings.next[_edge];
                if (Math.min(xs[_edge], xs[end]) <= maxX && Math.max(xs[_edge], xs[end]) >= minX
                        && Math.min(ys[_edge], ys[end]) <= maxY && Math.max(ys[_edge], ys[end]) >= minY)
                {
                    do
                    {
                        tests++;
                        weldCorner(corner, _edge);
                        weldCorner(_edge, corner);
                        corner = _rings.next[corner];
                    }
                    while (corner != hole);
                }
                _rings.budget.spendCornerTests(tests);
                _edge = _rings.next[_edge];
            }
            while (_edge != 0 && _rings.budget.cornerTestsLeft > testsLeft);
        }

        // Moves a node to where an edge of another ring begins, or adds a copy of it to the edge, if it is there.
        private function weldCorner(node:int, edge:int):void
        {
            var xs:Vector.<Number> = _rings.x;
            var ys:Vector.<Number> = _rings.y;
            var end:int = _rings.next[edge];
            var edgeX:Number = xs[end] - xs[edge];
            var edgeY:Number = ys[end] - ys[edge];
            var toX:Number = xs[node] - xs[edge];
            var toY:Number = ys[node] - ys[edge];
            var length:Number = Math.sqrt(edgeX * edgeX + edgeY * edgeY);
            var along:Number = edgeX * toX + edgeY * toY;
            if (Math.abs(toX) + Math.abs(toY) < TOUCH_DISTANCE)
            {
                xs[node] = xs[edge];
                ys[node] = ys[edge];
            }
            else if (along > TOUCH_DISTANCE * length && along < (length - TOUCH_DISTANCE) * length && Math.abs(edgeX * toY - edgeY * toX) < TOUCH_DISTANCE * length)
            {
                _rings.addCopy(node, edge);
            }
        }

        // The node of the outline at the place of a hole's node. Otherwise the one where the edge begins that a ray to the right meets first; -1 for none.
        private function atOrRightOf(hole:int):int
        {
            var xs:Vector.<Number> = _rings.x;
            var ys:Vector.<Number> = _rings.y;
            var edge:int = -1;
            var nearest:Number = Number.POSITIVE_INFINITY;
            var x:Number = xs[hole];
            var y:Number = ys[hole];
            var node:int = 0;
            do
            {
                if (_rings.areAtOnePlace(node, hole))
                {
                    return node;
                }
                var end:int = _rings.next[node];
                // the outline is counter-clockwise, so the edge to the right of an inner point goes upwards
                if (ys[node] <= y && y <= ys[end] && ys[node] < ys[end])
                {
                    // a corner on the ray is met at its own place, without rounding, because the hole may touch it
                    var hit:Number = ys[end] == y ? xs[end] : xs[node] + (y - ys[node]) * (xs[end] - xs[node]) / (ys[end] - ys[node]);
                    if (hit >= x && hit < nearest)
                    {
                        nearest = hit;
                        edge = node;
                    }
                }
                node = end;
            }
            while (node != 0);
            return edge;
        }

        // The corner that is visible from a hole's node. It is the right end of the edge that the ray from this node meets, unless other corners are in
        // the triangle between the node, the place where the ray meets the edge, and this end. Then it is the one of these that is nearest to the ray.
        private function visibleCorner(hole:int, edge:int):int
        {
            var xs:Vector.<Number> = _rings.x;
            var ys:Vector.<Number> = _rings.y;
            var end:int = _rings.next[edge];
            var corner:int = xs[edge] > xs[end] ? edge : end;
            var result:int = corner;
            // of a corner below the ray, all is as in a mirror
            var side:int = corner == end ? 1 : -1;
            var node:int = 0;
            do
            {
                var isInTriangle:Boolean = side * (ys[node] - ys[hole]) >= 0 && _rings.orient2d(edge, end, node) >= 0
                    && side * _rings.orient2d(corner, hole, node) >= 0;
                if (isInTriangle && xs[node] > xs[hole] && node != corner && isInInteriorAngle(node, hole))
                {
                    var turn:Number = side * _rings.orient2d(hole, node, result);
                    if (turn > 0 || turn == 0 && xs[node] < xs[result])
                    {
                        result = node;
                    }
                }
                node = _rings.next[node];
            }
            while (node != 0);
            return result;
        }

        // A corner where bridges begin, or where holes touch, is in the ring several times. Returns the node at its place that has the hole on its
        // side of the others: of those that see it, the one whose next edge is the nearest clockwise.
        private function nodeThatSees(corner:int, hole:int):int
        {
            var next:Vector.<int> = _rings.next;
            // a hole that touches the corner begins there, and goes on to its next node
            var seen:int = _rings.areAtOnePlace(hole, corner) ? next[hole] : hole;
            var result:int = -1;
            var node:int = corner;
            do
            {
                if (_rings.areAtOnePlace(node, corner) && isInInteriorAngle(node, seen)
                        && (result < 0 || isInAngle(node, next[result], next[node], seen)))
                {
                    result = node;
                }
                node = next[node];
            }
            while (node != corner);
            return result < 0 ? corner : result;
        }

        // Whether the direction from a corner to another node goes into the polygon.
        private function isInInteriorAngle(corner:int, node:int):Boolean
        {
            return isInAngle(corner, _rings.next[corner], node, _rings.previous[corner]);
        }

        // Whether a turn to the left about a corner, from one node to another, meets the direction to a third one between them or at its end.
        private function isInAngle(corner:int, from:int, node:int, to:int):Boolean
        {
            var isAfter:Boolean = _rings.orient2d(corner, from, node) > 0;
            var isBefore:Boolean = _rings.orient2d(corner, node, to) >= 0;
            return _rings.orient2d(corner, from, to) > 0 ? isAfter && isBefore : isAfter || isBefore;
        }
    }
}
