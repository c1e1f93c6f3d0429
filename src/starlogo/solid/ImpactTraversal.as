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
    internal final class ImpactTraversal extends PairTraversal
    {
        private var _sweep:BoxSweep = new BoxSweep();
        private var _pair:BoxPair = new BoxPair();

        // The motion. Once a touch is found, it ends there: at most Tolerances.SAME_TIME later, because a pair of triangles that touches by then may still
        // count as the first.
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
            _motion = motion;
            _first = out;
            out.reset();
            _pair.margin = trees.pose.margin + Touching.marginOfMotion(relative.x, relative.y, relative.z)
                + Touching.marginOfMotion(motion.x, motion.y, motion.z);
            visitPairs(trees, _pair, kernel);
            motion.time = out.time;
        }

        /** Moves the boxes to where no face separates them. @inheritDoc */
        override protected function isPossible(trees:TreePair, pair:BoxPair, areTested:Boolean):Boolean
        {
            var motion:RelativeMotion = _motion;
            if (areTested)
            {
                _sweep.findTimeOfImpact(pair, motion);
            }
            else
            {
                _sweep.findEarliestTime(pair, motion);
            }
            if (!(motion.time < motion.latestTime) && (_first.time != RelativeMotion.NEVER || motion.time == RelativeMotion.NEVER))
            {
                return false;
            }
            pair.offsetX += motion.time * motion.x;
            pair.offsetY += motion.time * motion.y;
            pair.offsetZ += motion.time * motion.z;
            return true;
        }

        /** @inheritDoc */
        override protected function measure(trees:TreePair, a:int, b:int, kernel:TrianglePairKernel):Boolean
        {
            if (trees.isExact)
            {
                kernel.findEarlier(a, b, _first);
            }
            else
            {
                // the time of the pair that was possible
                _first.time = _motion.latestTime = _motion.time;
                _first.a = a;
                _first.b = b;
            }
            // nothing touches earlier than at the beginning
            return !(_first.time > 0);
        }
    }
}
