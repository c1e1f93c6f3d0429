package starlogo.solid
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.convex.ClosestPoints;
    import starlogo.engine;
    import starlogo.hierarchy.BoxTree;
    import starlogo.hierarchy.LeafTest;
    import starlogo.hierarchy.RelativePose;
    import starlogo.intersection.ConvexTriangle;

    use namespace engine;

    /** Finds the distance of a solid structure from the triangles in leaves. */
    internal final class LeafStructureDistance extends LeafTest
    {
        /** The index of the nearest triangle so far in the hierarchy's order, or -1. */
        public var triangle:int = -1;

        private var _solid:Solid;
        private var _test:ConvexTriangle = new ConvexTriangle();

        // The structure's extents: least x, greatest x, least y, ...
        private var _extents:Vector.<Number> = new Vector.<Number>(6, true);

        // The closest points of the structure and the nearest triangle so far.
        private var _nearest:ClosestPoints = new ClosestPoints();

        public function LeafStructureDistance()
        {
            points = new ClosestPoints();
        }

        /**
         * Begins with a model that has triangles.
         *
         * @param model the model's hierarchy
         * @param structure in the space of another model
         * @param pose the other model's pose in the first one's space
         */
        public function begin(model:SolidHierarchy, structure:BoundingStructure, pose:RelativePose):void
        {
            _solid = model.facets;
            _test.begin(structure, pose.placement);
            _test.structure.extentsInto(_extents);
            _nearest.distance = Infinity;
            triangle = -1;
        }

        /** @inheritDoc */
        override public function touch(treeA:BoxTree, a:int, treeB:BoxTree, b:int):Boolean
        {
            var isNearer:Boolean = false;
            var end:int = treeA.end[a];
            for (var i:int = treeA.first[a]; i < end && _nearest.distance > 0; i++)
            {
                if (squaredGap(_extents, _solid.corners, 9 * i) < _nearest.distance * _nearest.distance)
                {
                    triangleTests++;
                    _test.setTriangle(_solid.corners, 9 * i);
                    if (_test.findCloser(_nearest))
                    {
                        isNearer = true;
                        triangle = i;
                    }
                }
            }
            if (isNearer)
            {
                least = _nearest.distance;
                points.copyFrom(_nearest);
                points.swapShapes();
            }
            return isNearer;
        }
    }
}
