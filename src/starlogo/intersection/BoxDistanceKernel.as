package starlogo.intersection
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.intersection.distance.DistanceResult;

    /** Finds the distance of two boxes. Only questions ask for it. */
    internal final class BoxDistanceKernel extends PairKernel
    {
        private var _edgesA:BoxEdgeDistance = new BoxEdgeDistance();
        private var _edgesB:BoxEdgeDistance = new BoxEdgeDistance();

        /** @inheritDoc */
        override public function findClosest(a:BoundingStructure, b:BoundingStructure, out:DistanceResult):void
        {
            var boxA:Box = a as Box;
            var boxB:Box = b as Box;
            // The order is always the same, so that rounding is the same for (a, b) and (b, a).
            if (boxA.center.x > boxB.center.x || (boxA.center.x == boxB.center.x && isAfter(boxA.center, boxB.center)))
            {
                findClosest(b, a, out);
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
