package starlogo.solid
{
    import starlogo.geometry.Tolerances;
    import starlogo.hierarchy.TreeCounts;
    import starlogo.intersection.boxes.BoxPair;
    import starlogo.intersection.boxes.BoxSeparation;

    /**
     * Decides whether two standing trees overlap.
     *
     * <p>In the space of tree a, its own boxes are axis-aligned, and all boxes of tree b have the same rotation. So a pair of boxes takes a few products
     * (Gottschalk, Lin and Manocha, "OBBTree", SIGGRAPH 1996; Ericson, "Real-Time Collision Detection", §4.4.1).</p>
     *
     * <p>The axes of the edges are tried only for pairs of leaves whose boxes are tested. Higher up, the next boxes separate most of what these axes would
     * separate (van den Bergen, "Efficient collision detection of complex deformable models using AABB trees", 1997).</p>
     *
     * @private
     */
    public final class OverlapTraversal extends PairTraversal
    {
        /** Result of <code>find()</code>: the roots are apart. */
        public static const APART:int = 0;

        /** Result of <code>find()</code>: the roots overlap, but no leaves touch. */
        public static const ONLY_ROOTS:int = 1;

        /** Result of <code>find()</code>: two leaves touch. */
        public static const OVERLAPPING:int = 2;

        // The absolute values of its rotation are larger by a rounding error, because cross products of nearly parallel edges cancel.
        private var _pair:BoxPair = new BoxPair();

        private var _isFound:Boolean = false;

        /** @param counts counts the pairs of nodes that are visited */
        public function OverlapTraversal(counts:TreeCounts)
        {
            super(counts);
        }

        /**
         * Finds whether two leaves touch: see BoxTree.
         *
         * @param kernel tests the triangles of two leaves, if the trees are exact. It has begun with them
         * @return APART, ONLY_ROOTS or OVERLAPPING
         */
        public function find(trees:TreePair, kernel:TrianglePairKernel):int
        {
            _pair.setRotation(trees.pose.placement, Tolerances.ROUNDING);
            _isFound = false;
            var areRootsMet:Boolean = visitPairs(trees, _pair, kernel);
            return _isFound ? OVERLAPPING : (areRootsMet ? ONLY_ROOTS : APART);
        }

        /** @inheritDoc */
        override protected function isPossible(trees:TreePair, pair:BoxPair, areTested:Boolean):Boolean
        {
            var margin:Number = trees.pose.margin;
            pair.aHalfX += margin;
            pair.aHalfY += margin;
            pair.aHalfZ += margin;
            return BoxSeparation.overlapAlongFacesOfA(pair) && BoxSeparation.overlapAlongFacesOfB(pair)
                && (!areTested || BoxSeparation.overlapAcrossEdges(pair));
        }

        /** @inheritDoc */
        override protected function measure(trees:TreePair, a:int, b:int, kernel:TrianglePairKernel):Boolean
        {
            _isFound = !trees.isExact || kernel.areTouching(a, b);
            return _isFound;
        }
    }
}
