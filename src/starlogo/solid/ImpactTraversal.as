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
        private var _sweep:BoxSweep = new BoxSweep();
        private var _pair:BoxPair = new BoxPair();

        // The motion, up to the best time so far.
        private var _motion:RelativeMotion;

        // Receives the first touch.
        private var _first:FirstImpact;

        /** @param counts counts the pairs of nodes that are visited */
        public function ImpactTraversal(counts:TreeCounts)
        {
            super(counts);
        }

        /**
         * Finds when two trees first touch, and which leaves or triangles do.
         *
         * @param motion of tree b, from the pose on; receives the time, and its latest time is overwritten
         * @param kernel tests the triangles of two leaves, if the trees are exact. It has begun with them and this motion
         * @param out receives the time and the leaves, or the indices of the triangles if the trees are exact
         */
        public function findFirst(trees:TreePair, motion:RelativeMotion, kernel:TrianglePairKernel, out:FirstImpact):void
        {
            var relative:Placement = trees.pose.placement;
            _pair.setRotation(relative);
            _pair.motion[0] = motion.x;
            _pair.motion[1] = motion.y;
            _pair.motion[2] = motion.z;
            _motion = motion;
            _first = out;
            out.reset();
            _pair.margin = trees.pose.margin + Touching.marginOfMotion(relative.x, relative.y, relative.z)
                + Touching.marginOfMotion(motion.x, motion.y, motion.z);
            visitPairs(trees, kernel);
            motion.time = out.time;
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
                kernel.findEarlier(a, b, _first);
                if (_first.time != RelativeMotion.NEVER)
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
                limit = _first.time = _motion.time;
                _first.a = a;
                _first.b = b;
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
