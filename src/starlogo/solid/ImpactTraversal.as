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
        private var _motion:RelativeMotion = new RelativeMotion();

        /** @param counts counts the pairs of nodes that are visited */
        public function ImpactTraversal(counts:TreeCounts)
        {
            super(counts);
        }

        /**
         * Finds when two trees first touch.
         *
         * @param motion of tree b, from the pose on
         * @param kernel tests the triangles of two leaves; null if their boxes are tested
         * @return the leaves or triangles that touch first, and the time; the next search overwrites it
         */
        public function findFirstPair(trees:TreePair, motion:RelativeMotion, kernel:TrianglePairKernel):BestPair
        {
            var relative:Placement = trees.pose.placement;
            _pair.setRotation(relative);
            _motion.copyVector(motion);
            _motion.latestTime = motion.latestTime;
            _pair.margin = trees.pose.margin + Touching.marginOfMotion(relative.x, relative.y, relative.z)
                + Touching.marginOfMotion(motion.x, motion.y, motion.z);
            return find(trees, kernel);
        }

        /**
         * @inheritDoc
         *
         * <p>The bound is the first time at which no face separates the boxes.</p>
         */
        override protected function estimate(trees:TreePair, a:int, b:int, out:BestPair):void
        {
            beginPair(trees, a, b, out);
            _sweep.findTimeOfFaces(_pair, _motion);
            out.bound = _motion.time;
        }

        /** @inheritDoc */
        override protected function measure(trees:TreePair, a:int, b:int, kernel:TrianglePairKernel, out:BestPair):void
        {
            if (kernel != null)
            {
                kernel.findEarlier(a, b, out);
                return;
            }
            beginPair(trees, a, b, out);
            _sweep.findTimeOfImpact(_pair, _motion);
            if (_motion.time < out.limit)
            {
                out.limit = out.time = _motion.time;
                out.a = a;
                out.b = b;
            }
        }

        // Reads the boxes of two nodes, and ends their motion at the best time so far.
        private function beginPair(trees:TreePair, a:int, b:int, best:BestPair):void
        {
            trees.readBoxes(a, b, _pair);
            if (best.limit < _motion.latestTime)
            {
                _motion.latestTime = best.limit;
            }
        }
    }
}
