package starlogo.hierarchy
{
    import starlogo.convex.RelativeMotion;
    import starlogo.geometry.Placement;
    import starlogo.geometry.Touching;
    import starlogo.intersection.boxes.BoxPair;
    import starlogo.intersection.boxes.BoxSweep;

    /**
     * Finds when two moving trees first touch, as RelativeMotion says. Parents touch no later than their children. The axes of the edges are
     * tried only for pairs whose boxes decide.
     *
     * @private
     */
    public final class ImpactTraversal extends BestPairTraversal
    {
        private var _sweep:BoxSweep = new BoxSweep();
        private var _pair:BoxPair = new BoxPair();

        /** @param counts counts the pairs of nodes that are visited */
        public function ImpactTraversal(counts:TreeCounts)
        {
            super(counts);
        }

        /**
         * Finds when two trees first touch.
         *
         * @param motion of the second tree, from the pose on
         * @param visitor decides about nodes that decide; null if their boxes do
         * @return the nodes or items that touch first, and the time; the next search overwrites it
         */
        public function findTouch(trees:PosedTrees, motion:RelativeMotion, visitor:NodePairVisitor):BestPair
        {
            var relative:Placement = trees.pose.placement;
            _pair.axes.readAxes(relative, 1);
            _pair.latest = motion.latest;
            _pair.motionX = motion.x;
            _pair.motionY = motion.y;
            _pair.motionZ = motion.z;
            _pair.margin = trees.pose.tolerance + Touching.marginOfMotion(relative.x, relative.y, relative.z)
                + Touching.marginOfMotion(motion.x, motion.y, motion.z);
            return find(trees, visitor);
        }

        /**
         * @inheritDoc
         *
         * <p>The bound is the first time at which no face separates the boxes.</p>
         */
        override protected function estimate(trees:PosedTrees, a:int, b:int, out:BestPair):void
        {
            readPair(trees, 6 * a, 6 * b, out);
            _sweep.findTimeOfFaces(_pair);
            out.bound = _pair.time;
        }

        /** @inheritDoc */
        override protected function measure(trees:PosedTrees, a:int, b:int, visitor:NodePairVisitor, out:BestPair):void
        {
            if (visitor != null)
            {
                visitor.findTouch(a, b, out);
                return;
            }
            readPair(trees, 6 * a, 6 * b, out);
            _sweep.findTime(_pair);
            if (_pair.time < out.least)
            {
                out.least = out.time = _pair.time;
                out.a = a;
                out.b = b;
            }
        }

        // Reads the boxes whose numbers begin at two indices. Times after the best one so far do not count.
        private function readPair(trees:PosedTrees, a:int, b:int, best:BestPair):void
        {
            var relative:Placement = trees.pose.placement;
            var boxesA:Vector.<Number> = trees.a.boxes;
            var boxesB:Vector.<Number> = trees.b.boxes;
            var pair:BoxPair = _pair;
            var scale:Number = relative.size;
            var x:Number = boxesB[b] * scale;
            var y:Number = boxesB[int(b + 1)] * scale;
            var z:Number = boxesB[int(b + 2)] * scale;
            pair.bX = boxesB[int(b + 3)] * scale;
            pair.bY = boxesB[int(b + 4)] * scale;
            pair.bZ = boxesB[int(b + 5)] * scale;
            pair.x = relative.r00 * x + relative.r01 * y + relative.r02 * z + relative.x - boxesA[a];
            pair.y = relative.r10 * x + relative.r11 * y + relative.r12 * z + relative.y - boxesA[int(a + 1)];
            pair.z = relative.r20 * x + relative.r21 * y + relative.r22 * z + relative.z - boxesA[int(a + 2)];
            pair.aX = boxesA[int(a + 3)];
            pair.aY = boxesA[int(a + 4)];
            pair.aZ = boxesA[int(a + 5)];
            if (best.least < pair.latest)
            {
                pair.latest = best.least;
            }
        }
    }
}
