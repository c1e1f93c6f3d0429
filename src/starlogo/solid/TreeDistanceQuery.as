package starlogo.solid
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.convex.ClosestPoints;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.hierarchy.BoxDistanceTraversal;
    import starlogo.hierarchy.LeafTest;
    import starlogo.hierarchy.RelativePose;
    import starlogo.hierarchy.StructureLeaf;

    use namespace engine;

    /**
     * Finds the distance and the closest points of two models: two trees, or a tree and a structure. It measures the nodes that
     * TreeOverlapQuery tests, or the triangles.
     *
     * @private
     */
    public final class TreeDistanceQuery
    {
        private var _overlaps:TreeOverlapQuery;
        private var _pose:RelativePose = new RelativePose();
        private var _boxes:BoxDistanceTraversal = new BoxDistanceTraversal();

        // The tests that decide about leaves.
        private var _leaf:StructureLeaf = new StructureLeaf();
        private var _trianglePairs:LeafDistanceTest = new LeafDistanceTest();
        private var _triangles:LeafStructureDistance = new LeafStructureDistance();

        /** @param overlaps finds a point of two models that overlap */
        public function TreeDistanceQuery(overlaps:TreeOverlapQuery)
        {
            _overlaps = overlaps;
        }

        /** The number of pairs of nodes visited since resetCounts. */
        public function get nodeVisits():int
        {
            return _boxes.nodeVisits;
        }

        /** The number of pairs of triangles, or of a triangle and a structure, measured since resetCounts. */
        public function get triangleTests():int
        {
            return _trianglePairs.triangleTests + _triangles.triangleTests;
        }

        /** Sets all counts to 0. */
        public function resetCounts():void
        {
            _boxes.nodeVisits = _trianglePairs.triangleTests = _triangles.triangleTests = 0;
        }

        /**
         * Finds the distance and the closest points.
         *
         * @param areTouching whether the two overlap. If so, a point of both is found
         * @param out receives the distance and the points, in the world
         */
        public function findClosest(pair:TreePair, areTouching:Boolean, out:ClosestPoints):void
        {
            _pose.relate(pair.placementA, pair.placementB);
            if (pair.b == null)
            {
                measureStructure(pair.a, pair.depthA, pair.structureB, pair.isExact);
            }
            else
            {
                measureTree(pair.a, pair.depthA, pair.b, pair.depthB, pair.isExact);
            }
            out.copyPoints(_boxes.points);
            out.distance = _boxes.bounds.least * pair.placementA.size;
            // a point of both is known already if the measured distance is 0
            var isPointNeeded:Boolean = areTouching && out.distance > 0;
            var placement:Placement = isPointNeeded ? _overlaps.findCommonPoint(pair, out) : pair.placementA;
            out.settle(areTouching);
            out.place(placement);
        }

        /** The number of the triangle that is nearest to a structure, as the model counts them. The pair's triangles decide. */
        public function nearestTriangle(pair:TreePair):int
        {
            _pose.relate(pair.placementA, pair.placementB);
            measureStructure(pair.a, pair.depthA, pair.structureB, true);
            return _triangles.triangle < 0 ? -1 : pair.a.tree.order[_triangles.triangle];
        }

        private function measureTree(a:SolidHierarchy, depthA:int, b:SolidHierarchy, depthB:int, isExact:Boolean):void
        {
            _boxes.structure = null;
            _boxes.find(_pose, a.tree, depthA, b.tree, depthB, isExact ? _trianglePairs.begin(a, b, _pose) : null);
        }

        private function measureStructure(a:SolidHierarchy, depthA:int, b:BoundingStructure, isExact:Boolean):void
        {
            var decider:LeafTest = null;
            if (isExact)
            {
                _triangles.begin(a, b, _pose);
                decider = _triangles;
            }
            _leaf.begin(b, _pose);
            _boxes.structure = _leaf.moved;
            _boxes.find(_leaf.pose, a.tree, depthA, _leaf.tree, 1, decider);
        }
    }
}
