package starlogo.solid
{
    import starlogo.convex.ClosestPoints;
    import starlogo.convex.RelativeMotion;
    import starlogo.engine;
    import starlogo.hierarchy.BoxTraversal;
    import starlogo.hierarchy.NodePairTest;
    import starlogo.hierarchy.RelativePose;
    import starlogo.hierarchy.TreeCounts;
    import starlogo.hierarchy.NodeStructureTest;

    use namespace engine;

    /**
     * Tests whether two models overlap where they are: two trees, or a tree and a structure (thesis §4.6). Nothing is allocated once the stacks
     * have grown and the models' triangles are prepared.
     *
     * <p>The thesis transforms both structures into the world for each pair of nodes (§4.5). Here one RelativePose for each pair of models
     * transforms the second model into the first model's space. There a traversal of pairs of nodes decides, depth-first, or a search for
     * the nodes near a structure. For exact tests, the nodes' triangles decide.</p>
     *
     * <p>The answers are nested. The nodes cover only the surface, so a ContainmentTest decides about a model inside a closed one.</p>
     *
     * @private
     */
    public final class TreeOverlapQuery
    {
        private var _traversal:BoxTraversal;

        // What decides about nodes.
        private var _trianglePairTest:TrianglePairTest;
        private var _nodeTest:NodeStructureTest;
        private var _triangleTest:TriangleStructureTest;
        private var _containment:ContainmentTest = new ContainmentTest();

        // The motion of a structure that stands.
        private var _still:RelativeMotion = new RelativeMotion();

        /** @param counts counts what the query does */
        public function TreeOverlapQuery(counts:TreeCounts)
        {
            _traversal = new BoxTraversal(counts);
            _trianglePairTest = new TrianglePairTest(counts);
            _nodeTest = new NodeStructureTest(counts);
            _triangleTest = new TriangleStructureTest(counts);
        }

        /** Whether two models overlap in the pair's pose. */
        public function areOverlapping(pair:TreePair):Boolean
        {
            var a:ModelTree = pair.a;
            var b:ModelTree = pair.b;
            var pose:RelativePose = pair.pose;
            if (b == null)
            {
                var found:int = pair.isExact ? _triangleTest.findTouch(a, pair.structureB, pose, _still)
                    : _nodeTest.findTouch(a.boxTree, pair.depthA, pair.structureB, pose, _still);
                return found >= 0 || _containment.findInside(pair, null);
            }
            var decider:NodePairTest = pair.isExact ? _trianglePairTest.begin(a, b, pose) : null;
            // If the roots do not overlap, neither model is inside of the other. This holds for most models that are close but do not collide.
            return _traversal.find(pose, a.boxTree, pair.depthA, b.boxTree, pair.depthB, decider)
                || _traversal.rootsOverlapped && _containment.findInside(pair, null);
        }

        /**
         * Finds a point of two models that overlap although their measured distance is more than 0: one is inside of the other.
         *
         * @param out receives the point twice, in the world; left as it is if no such point is known
         * @return whether it is known
         */
        public function findCommonPoint(pair:TreePair, out:ClosestPoints):Boolean
        {
            return _containment.findInside(pair, out);
        }
    }
}
