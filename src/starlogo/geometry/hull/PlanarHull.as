package starlogo.geometry.hull
{
    import starlogo.steps.StepSequence;

    /**
     * The convex hull of points in a plane (Andrew, "Another Efficient Algorithm for Convex Hulls in Two Dimensions",
     * Information Processing Letters 9(5), 1979), in three steps: the sorting, and either half.
     *
     * @private
     */
    public final class PlanarHull extends StepSequence
    {
        /**
         * The hull's corners, as indices of points, counter-clockwise from the one with the least x; when no step is left.
         * On a line: its two ends; in a point: that point.
         */
        public var corners:Vector.<int> = new Vector.<int>();

        private var _points:Vector.<Number>;
        private var _order:Array = null;

        /**
         * @param points x, y of each: whole numbers from 0 to QuickHull.GRID, with which every decision is exact
         */
        public function PlanarHull(points:Vector.<Number>)
        {
            _points = points;
            call(sortByXThenY).call(addLowerHalf).call(addUpperHalf);
        }

        private function sortByXThenY():void
        {
            var keys:Array = new Array(_points.length / 2);
            for (var i:int = 0; i < keys.length; i++)
            {
                keys[i] = _points[2 * i] * (2 * QuickHull.GRID) + _points[2 * i + 1];
            }
            _order = keys.sort(Array.NUMERIC | Array.RETURNINDEXEDARRAY) as Array;
        }

        private function addLowerHalf():void
        {
            addHalf(0);
        }

        private function addUpperHalf():void
        {
            _order.reverse();
            addHalf(corners.length - 1);
            if (corners.length > 1)
            {
                corners.length--;
            }
        }

        // Keeps left turns only. Corners before the index keep are those of the other half.
        private function addHalf(keep:int):void
        {
            var points:Vector.<Number> = _points;
            var hull:Vector.<int> = corners;
            var count:int = _order.length;
            for (var i:int = keep == 0 ? 0 : 1; i < count; i++)
            {
                var point:int = _order[i];
                while (hull.length > keep + 1 && !turnsLeft(points, hull[hull.length - 2], hull[hull.length - 1], point))
                {
                    hull.pop();
                }
                var last:int = hull.length == 0 ? -1 : hull[hull.length - 1];
                if (last < 0 || points[2 * last] != points[2 * point] || points[2 * last + 1] != points[2 * point + 1])
                {
                    hull.push(point);
                }
            }
        }

        private static function turnsLeft(points:Vector.<Number>, a:int, b:int, c:int):Boolean
        {
            var x:Number = points[2 * a];
            var y:Number = points[2 * a + 1];
            return (points[2 * b] - x) * (points[2 * c + 1] - y) > (points[2 * b + 1] - y) * (points[2 * c] - x);
        }
    }
}
