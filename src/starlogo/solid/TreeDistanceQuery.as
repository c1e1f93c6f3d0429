package starlogo.solid
{
    import starlogo.convex.ClosestPoints;
    import starlogo.convex.RelativeMotion;
    import starlogo.engine;
    import starlogo.hierarchy.DistanceTraversal;
    import starlogo.hierarchy.NodeDistanceVisitor;
    import starlogo.hierarchy.PosedTrees;
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
        private var _traversal:DistanceTraversal;

        // What decides about nodes.
        private var _trianglePairs:TrianglePairVisitor;
        private var _nodes:NodeDistanceVisitor;
        private var _triangles:TriangleDistanceVisitor;
        private var _containment:TreeContainmentQuery = new TreeContainmentQuery();
        private var _measured:ClosestPoints = new ClosestPoints();

        /**
         * @param counts counts what the query does
         */
        public function TreeDistanceQuery(counts:TreeCounts)
        {
            _traversal = new DistanceTraversal(counts);
            _trianglePairs = new TrianglePairVisitor(counts);
            _nodes = new NodeDistanceVisitor(counts);
            _triangles = new TriangleDistanceVisitor(counts);
        }

        /**
         * Finds the distance and the closest points.
         *
         * @param areTouching whether the two overlap. If so, a point of both is found
         * @param out receives the distance and the points, in the world
         */
        public function findClosest(pair:TreePair, areTouching:Boolean, out:ClosestPoints):void
        {
            pair.relate();
            findInSpaceOfFirst(pair, out);
            out.distance *= pair.placementA.size;
            // a point of both is known already if the measured distance is 0
            var isPointNeeded:Boolean = areTouching && out.distance > 0;
            if (!isPointNeeded || !_containment.findInside(pair, out))
            {
                out.correct(areTouching);
                out.place(pair.placementA);
            }
        }

        /** The number of the triangle that is nearest to a structure, as the model counts them. The pair must have triangles. */
        public function nearestTriangle(pair:TreePair):int
        {
            pair.relate();
            var slot:int = _triangles.find(pair.a, pair.structureB, pair.trees.pose, _measured);
            return slot < 0 ? -1 : pair.a.boxTree.items[slot];
        }

        // Finds the distance and the closest points in the first model's space.
        private function findInSpaceOfFirst(pair:TreePair, out:ClosestPoints):void
        {
            var trees:PosedTrees = pair.trees;
            if (pair.b != null)
            {
                _traversal.findClosest(trees, pair.isExact ? _trianglePairs.begin(pair, RelativeMotion.NONE) : null, out);
            }
            else if (pair.isExact)
            {
                _triangles.find(pair.a, pair.structureB, trees.pose, out);
            }
            else
            {
                _nodes.find(trees.a, trees.depthA, pair.structureB, trees.pose, out);
            }
        }
    }
}
