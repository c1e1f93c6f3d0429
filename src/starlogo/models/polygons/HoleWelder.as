package starlogo.models.polygons
{
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;

    /**
     * Welds the holes of a polygon: where a hole touches the outline or another hole, both get a corner at one place. So a touch counts also if
     * rounding has put it inside or outside.
     */
    internal final class HoleWelder
    {
        // Corners touch what they are closer to. The outline has a size of about 1. Files round to seven digits.
        private static const TOUCH_DISTANCE:Number = 1e-6;

        /**
         * The steps that weld all holes. They end early if no tests of corners are left.
         *
         * @param rings contains the outline and the holes, which are not joined yet
         */
        internal static function welding(rings:PolygonRings):Steps
        {
            return new StepSequence().beginEach(rings.starts.length - 1, function(index:int):Steps
                {
                    return weldingHole(rings, index + 1);
                });
        }

        // The steps that weld a hole to the edges of the rings before it. Ring 0 is the outline.
        private static function weldingHole(rings:PolygonRings, hole:int):Steps
        {
            var xs:Vector.<Number> = rings.x;
            var first:int = rings.starts[hole];
            var minX:Number = Number.POSITIVE_INFINITY;
            var maxX:Number = -minX;
            var corner:int = first;
            do
            {
                minX = Math.min(minX, xs[corner] - TOUCH_DISTANCE);
                maxX = Math.max(maxX, xs[corner] + TOUCH_DISTANCE);
                corner = rings.next[corner];
            }
            while (corner != first);
            // the ring before the hole, and the node where its next edge begins
            var ring:int = 0;
            var edge:int = 0;
            return new StepSequence().repeat(function():Boolean
                {
                    var testsLeft:Number = Math.max(0, rings.budget.cornerTestsLeft - PolygonRings.TESTS_PER_STEP);
                    while (ring < hole && rings.budget.cornerTestsLeft > testsLeft)
                    {
                        var end:int = rings.next[edge];
                        // most edges are beside the hole
                        var isBeside:Boolean = Math.min(xs[edge], xs[end]) > maxX || Math.max(xs[edge], xs[end]) < minX;
                        rings.budget.spendCornerTests(isBeside ? 1 : weldEdge(rings, edge, first));
                        edge = rings.next[edge];
                        if (edge == rings.starts[ring])
                        {
                            edge = rings.starts[++ring];
                        }
                    }
                    return ring < hole && rings.budget.cornerTestsLeft > 0;
                });
        }

        // Welds the corners of a hole to an edge of another ring. Returns the number of tests.
        private static function weldEdge(rings:PolygonRings, edge:int, first:int):int
        {
            var tests:int = 1;
            var corner:int = first;
            do
            {
                tests++;
                weldCorner(rings, corner, edge);
                weldCorner(rings, edge, corner);
                corner = rings.next[corner];
            }
            while (corner != first);
            return tests;
        }

        // Moves a node to where an edge of another ring begins, or adds a copy of it to the edge, if it is there.
        private static function weldCorner(rings:PolygonRings, node:int, edge:int):void
        {
            var xs:Vector.<Number> = rings.x;
            var ys:Vector.<Number> = rings.y;
            var end:int = rings.next[edge];
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
                rings.addCopy(node, edge);
            }
        }
    }
}
