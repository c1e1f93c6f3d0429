package starlogo.solid
{
    import starlogo.convex.ClosestPoints;
    import starlogo.convex.ContactPoint;
    import starlogo.convex.RelativeMotion;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.hierarchy.BoxTraversal;
    import starlogo.hierarchy.FirstTouch;
    import starlogo.hierarchy.NodePairTest;
    import starlogo.hierarchy.RelativePose;
    import starlogo.hierarchy.TreeCounts;
    import starlogo.hierarchy.NodeStructureTest;

    use namespace engine;

    /**
     * Tests whether two standing models overlap: two trees, or a tree and a structure (thesis §4.6). Nothing is allocated once the stacks
     * have grown and the models' triangles are prepared.
     *
     * <p>The thesis transforms both structures into the world for each pair of nodes (§4.5). Here one RelativePose for each pair of models
     * transforms the second model into the first model's space. There a traversal of pairs of nodes decides, depth-first, or a search for
     * the nodes near a structure. For exact tests, the nodes' triangles decide.</p>
     *
     * <p>It also finds when a structure that moves first touches a tree, because the same searches decide. TreeImpactQuery asks for that.</p>
     *
     * <p>The answers are nested. The nodes cover only the surface, so a ContainmentTest decides about a model inside a closed one.</p>
     *
     * @private
     */
    public final class TreeOverlapQuery
    {
        // Transforms the second model into the first model's space.
        private var _pose:RelativePose = new RelativePose();

        private var _traversal:BoxTraversal;

        // What decides about nodes.
        private var _trianglePairTest:TrianglePairTest;
        private var _nodeTest:NodeStructureTest;
        private var _triangleTest:TriangleStructureTest;
        private var _containment:ContainmentTest = new ContainmentTest();
        private var _touch:FirstTouch = new FirstTouch();

        /** @param counts counts what the query does */
        public function TreeOverlapQuery(counts:TreeCounts)
        {
            _traversal = new BoxTraversal(counts);
            _trianglePairTest = new TrianglePairTest(counts);
            _nodeTest = new NodeStructureTest(counts);
            _triangleTest = new TriangleStructureTest(counts);
        }

        /** Whether two standing models overlap. */
        public function areOverlapping(pair:TreePair):Boolean
        {
            return areOverlappingAt(pair, pair.placementA);
        }

        /** Whether two models overlap, if the first one stands at another place than that of the pair. */
        public function areOverlappingAt(pair:TreePair, placementA:Placement):Boolean
        {
            var a:ModelTree = pair.a;
            var b:ModelTree = pair.b;
            var pose:RelativePose = _pose;
            pose.relate(placementA, pair.placementB);
            if (b == null)
            {
                findStructureTouch(pair, pose, RelativeMotion.NONE, _touch);
                return _touch.time == 0 || _containment.findInside(pair, pose, null);
            }
            var decider:NodePairTest = pair.isExact ? _trianglePairTest.begin(a, b, pose) : null;
            // If the roots do not overlap, neither model is inside of the other. This holds for most models that are close but do not collide.
            return _traversal.find(pose, a.boxTree, pair.depthA, b.boxTree, pair.depthB, decider)
                || _traversal.rootsOverlapped && _containment.findInside(pair, pose, null);
        }

        /**
         * Finds when the structure that stands for the second model first touches the first model: a triangle of it, or a node.
         *
         * @param pose the second model's pose in the first model's space
         * @param motion of the structure, from the pose on. If it is still, it touches at time 0 or never
         * @param out receives the time and the triangle or node
         */
        internal function findStructureTouch(pair:TreePair, pose:RelativePose, motion:RelativeMotion, out:FirstTouch):void
        {
            if (pair.isExact)
            {
                _triangleTest.findTouch(pair.a, pair.structureB, pose, motion, out);
            }
            else
            {
                _nodeTest.findTouch(pair.a.boxTree, pair.depthA, pair.structureB, pose, motion, out);
            }
        }

        /**
         * Finds the contact of the structure with a triangle that it touches, in the first model's space, after <code>findStructureTouch()</code>.
         *
         * @param slot the triangle's slot
         * @param motion of the structure, which is where it is at the motion's time
         * @param out receives the contact, with a normal from the triangle to the structure
         */
        internal function findTriangleContact(slot:int, motion:RelativeMotion, out:ContactPoint):void
        {
            _triangleTest.findContact(slot, motion, out);
        }

        /**
         * Finds a point of two models that overlap although their measured distance is more than 0: one is inside of the other.
         *
         * @param out receives the point twice, in the world; left as it is if no such point is known
         * @return whether it is known
         */
        public function findCommonPoint(pair:TreePair, out:ClosestPoints):Boolean
        {
            _pose.relate(pair.placementA, pair.placementB);
            return _containment.findInside(pair, _pose, out);
        }
    }
}
