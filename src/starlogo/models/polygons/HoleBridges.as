package starlogo.models.polygons
{
    import starlogo.models.files.FileBudget;
    import starlogo.steps.Steps;

    /**
     * Joins each hole of a polygon to the outline by a bridge, so that one ring is left (D. Eberly, "Triangulation by Ear Clipping", 2002). A hole
     * whose rightmost corner is on an edge needs no bridge.
     */
    internal final class HoleBridges implements Steps
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

        /** @inheritDoc Joins holes until none is left, or for one step. Holes outside the outline are left out. */
        public function step():Boolean
        {
            var budget:FileBudget = _rings.budget;
            var end:Number = budget.cornerTestsLeft - PolygonRings.TESTS_PER_STEP;
            while (_nodes.length > 0 && budget.cornerTestsLeft > end)
            {
                addHole(_nodes.pop());
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

        // Joins a hole to the edge that its rightmost node is on, or by a bridge to a corner of the outline that sees this node.
        private function addHole(hole:int):void
        {
            if (_rings.budget.cornerTestsLeft <= 0)
            {
                return;
            }
            // the search goes around the outline three times
            _rings.budget.spendCornerTests(3 * _rings.countFrom(_outline));
            var edge:int = edgeRightOf(hole);
            // without one, the hole is not inside the outline
            if (edge < 0)
            {
                return;
            }
            var end:int = _rings.next[edge];
            var y:Number = _rings.y[hole];
            var corner:int = _rings.y[edge] == y ? edge : (_rings.y[end] == y ? end : -1);
            var touchesCorner:Boolean = corner >= 0 && _rings.x[corner] == _rings.x[hole];
            if (_rings.orient2d(edge, end, hole) > 0 || touchesCorner)
            {
                _rings.bridge(nodeThatSees(corner < 0 ? visibleCorner(hole, edge) : corner, hole), hole);
            }
            else
            {
                _rings.insert(edge, hole);
            }
        }

        // The node where the edge begins that a ray to the right from a hole's node meets first, or a level edge that the hole's node is on; -1 for none.
        private function edgeRightOf(hole:int):int
        {
            var xs:Vector.<Number> = _rings.x;
            var ys:Vector.<Number> = _rings.y;
            var edge:int = -1;
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
                    // a corner on the ray is met at its own place, without rounding, because the hole may touch it
                    var hit:Number = ys[end] == y ? xs[end] : xs[node] + (y - ys[node]) * (xs[end] - xs[node]) / (ys[end] - ys[node]);
                    if (hit >= x && hit < nearest)
                    {
                        nearest = hit;
                        edge = node;
                    }
                }
                else if (ys[node] == y && ys[end] == y && (xs[node] - x) * (xs[end] - x) < 0)
                {
                    return node;
                }
                node = end;
            }
            while (node != _outline);
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
            var node:int = _outline;
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
            while (node != _outline);
            return result;
        }

        // A corner where bridges begin, or where holes touch, is in the ring several times. Returns the node at its place that has the hole on its
        // side of the others: of those that see it, the one whose next edge is the nearest clockwise.
        private function nodeThatSees(corner:int, hole:int):int
        {
            var xs:Vector.<Number> = _rings.x;
            var ys:Vector.<Number> = _rings.y;
            var next:Vector.<int> = _rings.next;
            // a hole that touches the corner begins there, and goes on to its next node
            var seen:int = xs[hole] == xs[corner] && ys[hole] == ys[corner] ? next[hole] : hole;
            var result:int = -1;
            var node:int = corner;
            do
            {
                if (xs[node] == xs[corner] && ys[node] == ys[corner] && isInInteriorAngle(node, seen)
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
