package starlogo.models.polygons
{
    import starlogo.models.files.FileBudget;
    import starlogo.steps.Steps;

    /**
     * Welds the holes of a polygon: where a hole touches the outline or another hole, both get a corner at one place. So a touch counts also if
     * rounding has put it inside or outside.
     */
    internal final class HoleWelder implements Steps
    {
        // Corners touch what they are closer to. The outline has a size of about 1. Files round to seven digits.
        private static const TOUCH_DISTANCE:Number = 1e-6;

        private var _rings:PolygonRings;

        // The numbers of the present hole and of a ring before it, and the node where the next edge of this ring begins. Ring 0 is the outline.
        private var _hole:int = 1;
        private var _ring:int = 0;
        private var _edge:int = 0;

        /** @param rings contains the outline and the holes, which are not joined yet */
        public function HoleWelder(rings:PolygonRings)
        {
            _rings = rings;
        }

        /** @inheritDoc Ends early if no tests of corners are left. */
        public function step():Boolean
        {
            var budget:FileBudget = _rings.budget;
            var end:Number = Math.max(0, budget.cornerTestsLeft - PolygonRings.TESTS_PER_STEP);
            while (_hole < _rings.starts.length && budget.cornerTestsLeft > end)
            {
                weldHole(end);
            }
            return _hole < _rings.starts.length && budget.cornerTestsLeft > 0;
        }

        // Welds the present hole to the edges of the rings before it, until all are done, or as few tests are left as are given.
        private function weldHole(testsLeft:Number):void
        {
            var xs:Vector.<Number> = _rings.x;
            var hole:int = _rings.starts[_hole];
            var minX:Number = Number.POSITIVE_INFINITY;
            var maxX:Number = -minX;
            var corner:int = hole;
            do
            {
                minX = Math.min(minX, xs[corner] - TOUCH_DISTANCE);
                maxX = Math.max(maxX, xs[corner] + TOUCH_DISTANCE);
                corner = _rings.next[corner];
            }
            while (corner != hole);
            do
            {
                var tests:int = 1;
                var end:int = _rings.next[_edge];
                // most edges are beside the hole
                if (Math.min(xs[_edge], xs[end]) <= maxX && Math.max(xs[_edge], xs[end]) >= minX)
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
                if (_edge == _rings.starts[_ring])
                {
                    _edge = _rings.starts[++_ring];
                }
            }
            while (_ring < _hole && _rings.budget.cornerTestsLeft > testsLeft);
            if (_ring == _hole)
            {
                _hole++;
                _ring = 0;
                _edge = 0;
            }
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
    }
}
