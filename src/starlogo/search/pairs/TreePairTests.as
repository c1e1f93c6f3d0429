package starlogo.search.pairs
{
    import flash.geom.Vector3D;
    import starlogo.bounding.Sphere;
    import starlogo.convex.ClosestPoints;
    import starlogo.convex.ContactPoint;
    import starlogo.convex.RelativeMotion;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.hierarchy.TreeCounts;
    import starlogo.intersection.StructurePairs;
    import starlogo.search.Body;
    import starlogo.search.ModelShape;
    import starlogo.search.NarrowPhase;
    import starlogo.search.penetration.DisplacedPair;
    import starlogo.search.penetration.PenetrationSearch;
    import starlogo.search.TreeLimits;
    import starlogo.solid.ModelTree;
    import starlogo.solid.RelativePose;
    import starlogo.solid.TreeQuery;
    import starlogo.solid.TreeStructureQuery;
    import starlogo.solid.TreeTreeQuery;

    use namespace engine;

    /**
     * Tests two bodies of which at least one is a tree: whether they touch, when they touch, and how (thesis §4.6).
     *
     * @private
     */
    public final class TreePairTests extends PairTests
    {
        private static const POINT:Sphere = new Sphere(new Vector3D(), 0);

        private var _limits:TreeLimits;
        private var _counts:TreeCounts;
        private var _trees:TreeTreeQuery;
        private var _treeAndStructure:TreeStructureQuery;
        private var _penetrationSearch:PenetrationSearch;

        // The motion of the second body while the first one stands still: for a question in the reverse order.
        private var _reversed:RelativeMotion = new RelativeMotion();

        // The second body in the first one's space, for the contact of the structures around them.
        private var _pose:RelativePose = new RelativePose();

        // Where a point is, as the placement of the structure POINT.
        private var _at:Placement = new Placement();

        /**
         * @param limits how far trees are tested
         * @param counts counts the tests
         */
        public function TreePairTests(limits:TreeLimits, counts:TreeCounts)
        {
            _limits = limits;
            _counts = counts;
            _trees = new TreeTreeQuery(counts);
            _treeAndStructure = new TreeStructureQuery(counts);
            _penetrationSearch = new PenetrationSearch(new DisplacedPair(this));
        }

        /** Gives these tests to a narrow phase that does not have them. */
        public static function addTo(narrowPhase:NarrowPhase):void
        {
            narrowPhase.treeTests ||= new TreePairTests(narrowPhase.treeLimits, narrowPhase.counts.trees);
        }

        /** @inheritDoc */
        override public function areTouching(a:Body, b:Body):Boolean
        {
            _counts.pairTests++;
            return queryOf(a, b, a.comesAfter(b)).areTouching();
        }

        /** @inheritDoc */
        override public function findFirstTouch(a:Body, b:Body, motion:RelativeMotion, out:ContactPoint):void
        {
            var isReversed:Boolean = a.comesAfter(b);
            _counts.pairTests++;
            queryOf(a, b, isReversed).findFirstTouch(inOrder(motion, isReversed), out);
            finish(motion, isReversed, out);
        }

        /** @inheritDoc */
        override public function findImpactOfSurfaces(a:Body, b:Body, motion:RelativeMotion, out:ContactPoint):void
        {
            var isReversed:Boolean = a.comesAfter(b);
            _counts.pairTests++;
            queryOf(a, b, isReversed).findImpactOfSurfaces(inOrder(motion, isReversed), out);
            finish(motion, isReversed, out);
        }

        /** @inheritDoc */
        override public function findImpactOfSolids(a:Body, b:Body, motion:RelativeMotion, out:ContactPoint):void
        {
            var isReversed:Boolean = a.comesAfter(b);
            _counts.pairTests++;
            queryOf(a, b, isReversed).findImpactOfSolids(inOrder(motion, isReversed), out);
            finish(motion, isReversed, out);
        }

        /** @inheritDoc */
        override public function findContactOfParts(a:Body, b:Body, motion:RelativeMotion, out:ContactPoint):void
        {
            // Two trees stay in this order. AgentContacts.findContact puts two agents into the order of the list before, so a contact is the same in either order.
            var isReversed:Boolean = a.kind != ModelShape.TREE;
            queryOf(a, b, isReversed).findContact(inOrder(motion, isReversed), out);
            finish(motion, isReversed, out);
        }

        /** The covers are the structures around the trees. @inheritDoc */
        override public function findContactOfCovers(a:Body, b:Body, out:ContactPoint):void
        {
            _pose.setBetween(a.placement, b.placement, RelativeMotion.NONE, 0);
            StructurePairs.findContact(_pose.place(b.shape.structure), a.shape.structure, RelativeMotion.NONE, out);
            RelativePose.moveContactToWorld(out, a.placement, RelativeMotion.NONE);
        }

        /** @inheritDoc */
        override public function separate(a:Body, b:Body, motion:RelativeMotion, out:ContactPoint):void
        {
            // the contact's object may have been that of a contact with the ground
            out.forgetDeepest();
            _penetrationSearch.separate(a, b, motion, out);
        }

        /** @inheritDoc */
        override protected function findClosestInOrder(a:Body, b:Body, areTouching:Boolean, out:ClosestPoints):void
        {
            queryOf(a, b, false).findClosest(areTouching, out);
        }

        /**
         * Finds the number of the triangle of a body that is nearest to a point, as the model counts them; -1 if triangles do not decide.
         *
         * @param body a tree
         * @param point has the point
         */
        public function findNearestTriangle(body:Body, point:ContactPoint):int
        {
            _at.x = point.x;
            _at.y = point.y;
            _at.z = point.z;
            _treeAndStructure.setTo(body.shape.tree, body.placement, _limits.depthOf(body), POINT, _at);
            return _treeAndStructure.findNearestTriangle();
        }

        // Returns the question about two bodies, or about the two in the reverse order, of which the first one is a tree. The next call overwrites it.
        private function queryOf(a:Body, b:Body, isReversed:Boolean):TreeQuery
        {
            var first:Body = isReversed ? b : a;
            var second:Body = isReversed ? a : b;
            var tree:ModelTree = first.shape.tree;
            if (second.shape.tree != null)
            {
                return _trees.setTo(tree, first.placement, _limits.depthOf(first), second.shape.tree, second.placement, _limits.depthOf(second));
            }
            return _treeAndStructure.setTo(tree, first.placement, _limits.depthOf(first), second.shape.structure, second.placement);
        }

        // Returns the motion for this question: that of its first body relative to its second.
        private function inOrder(motion:RelativeMotion, isReversed:Boolean):RelativeMotion
        {
            if (isReversed)
            {
                _reversed.setReversed(motion);
                return _reversed;
            }
            return motion;
        }

        // Finishes this question: after the reverse order, copies the time to the given motion, and swaps the contact if there is one.
        private function finish(motion:RelativeMotion, isReversed:Boolean, out:ContactPoint):void
        {
            if (isReversed)
            {
                motion.time = _reversed.time;
                if (out != null && motion.time != RelativeMotion.NEVER)
                {
                    out.swap(motion);
                }
            }
        }
    }
}
