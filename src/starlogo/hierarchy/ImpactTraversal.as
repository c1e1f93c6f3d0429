package starlogo.hierarchy
{
    import starlogo.convex.RelativeMotion;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.geometry.Touching;
    import starlogo.intersection.sweep.BoxPair;
    import starlogo.intersection.sweep.BoxSweep;

    use namespace engine;

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

        // The latest time of the motion.
        private var _latest:Number = 1;

        /** @param counts counts the pairs of nodes that are visited */
        public function ImpactTraversal(counts:TreeCounts)
        {
            super(counts);
        }

        /**
         * Finds when two trees first touch. The other parameters are those of <code>BestPairTraversal.find()</code>.
         *
         * @param motion of the second tree, from the pose on
         * @return the nodes that touch first, and the time as <code>least</code>; the next search overwrites it
         */
        public function findTouch(pose:RelativePose, motion:RelativeMotion, treeA:BoxTree, depthA:int, treeB:BoxTree, depthB:int,
                visitor:BestPairVisitor):BestPair
        {
            var relative:Placement = pose.placement;
            _pair.axes.readAxes(relative, 1);
            _latest = motion.latest;
            _pair.motionX = motion.x;
            _pair.motionY = motion.y;
            _pair.motionZ = motion.z;
            _pair.margin = pose.tolerance + Touching.marginOfMotion(relative.x, relative.y, relative.z)
                + Touching.marginOfMotion(motion.x, motion.y, motion.z);
            return find(pose, treeA, depthA, treeB, depthB, visitor);
        }

        /**
         * @inheritDoc
         *
         * <p>The bound is the first time at which no face separates the boxes.</p>
         */
        override protected function estimate(pose:RelativePose, treeA:BoxTree, a:int, treeB:BoxTree, b:int, out:BestPair):void
        {
            readPair(pose.placement, treeA.boxes, 6 * a, treeB.boxes, 6 * b, out);
            _sweep.findTimeOfFaces(_pair);
            out.current = _pair.time;
        }

        /** @inheritDoc */
        override protected function measure(pose:RelativePose, treeA:BoxTree, a:int, treeB:BoxTree, b:int, out:BestPair):void
        {
            readPair(pose.placement, treeA.boxes, 6 * a, treeB.boxes, 6 * b, out);
            _sweep.findTime(_pair);
            out.current = _pair.time;
            if (out.current < out.least)
            {
                out.a = a;
                out.b = b;
            }
        }

        // Reads two boxes. Times after the best one so far do not count.
        private function readPair(relative:Placement, boxesA:Vector.<Number>, a:int, boxesB:Vector.<Number>, b:int, best:BestPair):void
        {
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
            pair.latest = best.least < _latest ? best.least : _latest;
        }
    }
}
