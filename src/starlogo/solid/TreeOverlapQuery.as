package starlogo.solid
{
    import starlogo.convex.RelativeMotion;
    import starlogo.hierarchy.OverlapTraversal;
    import starlogo.hierarchy.NodePairVisitor;
    import starlogo.hierarchy.RelativePose;
    import starlogo.hierarchy.TreeCounts;
    import starlogo.hierarchy.NodeTouchVisitor;

    /**
     * Tests whether two models overlap where they are: two trees, or a tree and a structure (thesis §4.6). Nothing is allocated once the stacks
     * have grown and the models' triangles are prepared.
     *
     * <p>The thesis transforms both structures into the world for each pair of nodes (§4.5). Here one RelativePose for each pair of models
     * transforms the second model into the first model's space. There a traversal of pairs of nodes decides, depth-first, or a search for
     * the nodes near a structure. For exact tests, the nodes' triangles decide.</p>
     *
     * <p>The answers are nested. The nodes cover only the surface, so a TreeContainmentQuery decides about a model inside a closed one.</p>
     *
     * @private
     */
    public final class TreeOverlapQuery
    {
        private var _traversal:OverlapTraversal;

        // What decides about nodes.
        private var _trianglePairs:TrianglePairVisitor;
        private var _nodes:NodeTouchVisitor;
        private var _triangles:TriangleTouchVisitor;
        private var _containment:TreeContainmentQuery = new TreeContainmentQuery();

        // The motion of a structure that stands.
        private var _still:RelativeMotion = new RelativeMotion();

        /** @param counts counts what the query does */
        public function TreeOverlapQuery(counts:TreeCounts)
        {
            _traversal = new OverlapTraversal(counts);
            _trianglePairs = new TrianglePairVisitor(counts);
            _nodes = new NodeTouchVisitor(counts);
            _triangles = new TriangleTouchVisitor(counts);
        }

        /** Whether two models overlap where they stand. */
        public function areOverlapping(pair:TreePair):Boolean
        {
            pair.relate();
            return overlapInPose(pair);
        }

        /** Whether one of two models, whose surfaces do not touch, is inside of the other. */
        public function isOneInside(pair:TreePair):Boolean
        {
            if (pair.b != null)
            {
                // only the traversal knows whether the roots overlap
                return areOverlapping(pair);
            }
            pair.relate();
            return _containment.findInside(pair, null);
        }

        /** Whether two models overlap in the pair's pose. */
        internal function overlapInPose(pair:TreePair):Boolean
        {
            if (pair.b == null)
            {
                var pose:RelativePose = pair.trees.pose;
                var found:int = pair.isExact ? _triangles.findTouch(pair.a, pair.structureB, pose, _still)
                    : _nodes.findTouch(pair.trees.a, pair.trees.depthA, pair.structureB, pose, _still);
                return found >= 0 || _containment.findInside(pair, null);
            }
            var visitor:NodePairVisitor = pair.isExact ? _trianglePairs.begin(pair, RelativeMotion.NONE) : null;
            var result:int = _traversal.find(pair.trees, visitor);
            // If the roots do not overlap, neither model is inside of the other. This holds for most models that are close but do not collide.
            return result == OverlapTraversal.OVERLAPPING || result == OverlapTraversal.ONLY_ROOTS && _containment.findInside(pair, null);
        }
    }
}
