package starlogo.solid
{
    import starlogo.convex.RelativeMotion;
    import starlogo.geometry.Placement;
    import starlogo.geometry.Touching;
    import starlogo.hierarchy.TreeCounts;
    import starlogo.intersection.boxes.BoxPair;
    import starlogo.intersection.boxes.BoxSweep;

    /**
     * Finds when two moving trees first touch, as RelativeMotion says. Parents touch no later than their children. The axes of the edges are
     * tried only for pairs of leaves.
     */
    internal final class ImpactTraversal extends BestPairTraversal
    {
        /** When the two first touch, or RelativeMotion.NEVER. Read only, but for the kernel, as the next two. */
        public var firstTime:Number = RelativeMotion.NEVER;

        /** The leaves that touch first, or the indices of triangles if a kernel tests these. Undefined if none touch. */
        public var firstA:int = 0;
        public var firstB:int = 0;

        private var _sweep:BoxSweep = new BoxSweep();
        private var _pair:BoxPair = new BoxPair();

        // The motion, up to the best time so far.
        private var _motion:RelativeMotion;

        /** @param counts counts the pairs of nodes that are visited */
        public function ImpactTraversal(counts:TreeCounts)
        {
            super(counts);
        }

        /**
         * Finds when two trees first touch, and which leaves or triangles do.
         *
         * @param motion of tree b, from the pose on; its time and its latest time are overwritten
         * @param kernel tests the triangles of two leaves, if the trees are exact. It has begun with them and this motion
         */
        public function findFirstPair(trees:TreePair, motion:RelativeMotion, kernel:TrianglePairKernel):void
        {
            var relative:Placement = trees.pose.placement;
            _pair.setRotation(relative);
            _motion = motion;
            firstTime = RelativeMotion.NEVER;
            _pair.margin = trees.pose.margin + Touching.marginOfMotion(relative.x, relative.y, relative.z)
                + Touching.marginOfMotion(motion.x, motion.y, motion.z);
            visitPairs(trees, kernel);
        }

        /**
         * @inheritDoc
         *
         * <p>The bound is the first time at which no face separates the boxes.</p>
         */
        override protected function estimate(trees:TreePair, a:int, b:int):void
        {
            beginPair(trees, a, b);
            _sweep.findEarliestTime(_pair, _motion);
            bound = _motion.time;
        }

        /** @inheritDoc */
        override protected function measure(trees:TreePair, a:int, b:int, kernel:TrianglePairKernel):void
        {
            if (trees.isExact)
            {
                kernel.findEarlier(a, b, this);
                if (firstTime != RelativeMotion.NEVER)
                {
                    // up to Tolerances.SAME_TIME later than the first time: a pair that touches by then may still count as the first
                    limit = _motion.latestTime;
                }
                return;
            }
            beginPair(trees, a, b);
            _sweep.findTimeOfImpact(_pair, _motion);
            if (_motion.time < limit)
            {
                limit = firstTime = _motion.time;
                firstA = a;
                firstB = b;
            }
        }

        // Reads the boxes of two nodes, and ends their motion at the best time so far.
        private function beginPair(trees:TreePair, a:int, b:int):void
        {
            trees.readBoxes(a, b, _pair);
            if (limit < _motion.latestTime)
            {
                _motion.latestTime = limit;
            }
        }
    }
}
