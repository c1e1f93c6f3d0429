package starlogo.intersection
{
    import starlogo.bounding.Box;
    import starlogo.intersection.distance.DistanceResult;

    /** Finds the distance of two boxes. */
    internal final class BoxDistance
    {
        private var _edgesA:BoxEdgeDistance = new BoxEdgeDistance();
        private var _edgesB:BoxEdgeDistance = new BoxEdgeDistance();

        /**
         * Finds the distance and the closest points.
         *
         * @param boxA half-extents may be 0
         * @param boxB in the same space
         * @param out receives the distance and the points
         */
        public function findClosest(boxA:Box, boxB:Box, out:DistanceResult):void
        {
            // The order is always the same, so that rounding is the same for (a, b) and (b, a).
            if (boxA.center.x > boxB.center.x || (boxA.center.x == boxB.center.x && isAfter(boxA.center, boxB.center)))
            {
                findClosest(boxB, boxA, out);
                out.swapShapes();
                return;
            }
            _edgesA.findNearest(boxA, boxB);
            if (_edgesA.squared > 0 && !_edgesA.isLeast())
            {
                _edgesB.findNearest(boxB, boxA);
                if (_edgesB.squared < _edgesA.squared)
                {
                    _edgesB.write(boxA, true, out);
                    return;
                }
            }
            _edgesA.write(boxB, false, out);
        }
    }
}
