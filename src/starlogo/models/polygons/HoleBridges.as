package starlogo.models.polygons
{
    import starlogo.models.files.FileBudget;
    import starlogo.steps.Steps;

    /**
     * Joins each hole of a polygon to the outline by a bridge, so that one ring is left (D. Eberly, "Triangulation by Ear Clipping", 2002).
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
            if (_rings.budget.cornerTestsLeft <= 0)
            {
                return;
            }
            // the search goes around the outline three times
            _rings.budget.spendCornerTests(3 * _rings.countFrom(_outline));
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
                    var met:int = ys[node] == y ? node : (ys[end] == y ? end : -1);
                    var hit:Number = met >= 0 ? xs[met] : xs[node] + (y - ys[node]) * (xs[end] - xs[node]) / (ys[end] - ys[node]);
                    if (hit >= x && hit < nearest)
                    {
                        nearest = hit;
                        edge = node;
                        corner = met >= 0 ? met : (xs[node] > xs[end] ? node : end);
                    }
                }
                node = end;
            }
            while (node != _outline);
            return corner < 0 || ys[corner] == y ? corner : nearestToRay(hole, edge, corner);
        }

        // The corner that is visible from a hole's node. It is the given corner of the edge that the ray from this node meets, unless others block
        // the line to it. Then it is the blocking corner nearest to the ray.
        private function nearestToRay(hole:int, edge:int, corner:int):int
        {
            var xs:Vector.<Number> = _rings.x;
            var result:int = corner;
            // counter-clockwise, a corner above the ray is to the left of one nearer to the ray
            var direction:int = _rings.y[corner] > _rings.y[hole] ? 1 : -1;
            var node:int = _outline;
            do
            {
                if (xs[node] > xs[hole] && node != corner && isBetween(node, hole, edge, corner) && seesInside(node, hole))
                {
                    var turn:Number = direction * _rings.orient2d(hole, node, result);
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

        // Whether a node is inside the triangle of a hole's node, the place where its ray meets an edge of the outline, and a corner of this edge, or
        // on the triangle's edge.
        private function isBetween(node:int, hole:int, edge:int, corner:int):Boolean
        {
            var ys:Vector.<Number> = _rings.y;
            // counter-clockwise, the triangle goes along the ray first if the corner is above it
            var direction:int = ys[corner] > ys[hole] ? 1 : -1;
            return direction * (ys[node] - ys[hole]) >= 0 && _rings.orient2d(edge, _rings.next[edge], node) >= 0
                && direction * _rings.orient2d(corner, hole, node) >= 0;
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
                if (xs[node] == xs[corner] && ys[node] == ys[corner] && seesInside(node, seen)
                        && (result < 0 || isTurnedTo(node, next[result], next[node], seen)))
                {
                    result = node;
                }
                node = next[node];
            }
            while (node != corner);
            return result < 0 ? corner : result;
        }

        // Whether the direction from a corner to another node goes into the polygon.
        private function seesInside(corner:int, node:int):Boolean
        {
            return isTurnedTo(corner, _rings.next[corner], node, _rings.previous[corner]);
        }

        // Whether a turn to the left about a corner, from one node to another, meets the direction to a third one between them.
        private function isTurnedTo(corner:int, from:int, node:int, to:int):Boolean
        {
            var isAfter:Boolean = _rings.orient2d(corner, from, node) > 0;
            var isBefore:Boolean = _rings.orient2d(corner, node, to) > 0;
            return _rings.orient2d(corner, from, to) > 0 ? isAfter && isBefore : isAfter || isBefore;
        }
    }
}
