package starlogo.solid
{
    import starlogo.convex.ClosestPoints;
    import starlogo.engine;
    import starlogo.hierarchy.BoxDistanceTraversal;
    import starlogo.hierarchy.NodeDistanceTest;
    import starlogo.hierarchy.NodePairSearch;
    import starlogo.hierarchy.TreeCounts;

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
        private var _traversal:BoxDistanceTraversal;

        // What decides about nodes.
        private var _trianglePairDistance:TrianglePairDistance;
        private var _nodeTest:NodeDistanceTest;
        private var _triangleTest:TriangleDistanceTest;
        private var _measured:ClosestPoints = new ClosestPoints();

        /**
         * @param overlaps finds a point of two models that overlap
         * @param counts counts what the query does
         */
        public function TreeDistanceQuery(overlaps:TreeOverlapQuery, counts:TreeCounts)
        {
            _overlaps = overlaps;
            _traversal = new BoxDistanceTraversal(counts);
            _trianglePairDistance = new TrianglePairDistance(counts);
            _nodeTest = new NodeDistanceTest(counts);
            _triangleTest = new TriangleDistanceTest(counts);
        }

        /**
         * Finds the distance and the closest points.
         *
         * @param areTouching whether the two overlap. If so, a point of both is found
         * @param out receives the distance and the points, in the world
         */
        public function findClosest(pair:TreePair, areTouching:Boolean, out:ClosestPoints):void
        {
            findInSpaceOfFirst(pair, out);
            out.distance *= pair.placementA.size;
            // a point of both is known already if the measured distance is 0
            var isPointNeeded:Boolean = areTouching && out.distance > 0;
            if (!isPointNeeded || !_overlaps.findCommonPoint(pair, out))
            {
                out.settle(areTouching);
                out.place(pair.placementA);
            }
        }

        /** The number of the triangle that is nearest to a structure, as the model counts them. The pair must have triangles. */
        public function nearestTriangle(pair:TreePair):int
        {
            var slot:int = _triangleTest.find(pair.a, pair.structureB, pair.pose, _measured);
            return slot < 0 ? -1 : pair.a.boxTree.order[slot];
        }

        // Finds the distance and the closest points in the first model's space.
        private function findInSpaceOfFirst(pair:TreePair, out:ClosestPoints):void
        {
            var a:ModelTree = pair.a;
            var b:ModelTree = pair.b;
            if (b != null)
            {
                var decider:NodePairSearch = pair.isExact ? _trianglePairDistance.begin(a, b, pair.pose) : null;
                _traversal.findClosest(pair.pose, a.boxTree, pair.depthA, b.boxTree, pair.depthB, decider, out);
            }
            else if (pair.isExact)
            {
                _triangleTest.find(a, pair.structureB, pair.pose, out);
            }
            else
            {
                _nodeTest.find(a.boxTree, pair.depthA, pair.structureB, pair.pose, out);
            }
        }
    }
}
