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

        /** @inheritDoc */
        override protected function estimate(pose:RelativePose, treeA:BoxTree, a:int, treeB:BoxTree, b:int, out:BestPair):void
        {
            sweep(pose.placement, treeA.boxes, a, treeB.boxes, b, false, out);
        }

        /** @inheritDoc */
        override protected function decide(pose:RelativePose, treeA:BoxTree, a:int, treeB:BoxTree, b:int, visitor:BestPairVisitor, out:BestPair):void
        {
            if (visitor != null)
            {
                visitor.findBest(treeA, a, treeB, b, out);
                return;
            }
            sweep(pose.placement, treeA.boxes, a, treeB.boxes, b, true, out);
            if (out.current < out.least)
            {
                out.a = a;
                out.b = b;
            }
        }

        // Sets the bound to the first time at which no face separates two boxes. If withEdges is true, no edge separates them then either.
        // If that time is after the least time, sets the bound to RelativeMotion.NEVER.
        private function sweep(relative:Placement, boxesA:Vector.<Number>, a:int, boxesB:Vector.<Number>, b:int, withEdges:Boolean, out:BestPair):void
        {
            var pair:BoxPair = _pair;
            var scale:Number = relative.size;
            var at:int = 6 * b;
            var bX:Number = boxesB[at] * scale;
            var bY:Number = boxesB[int(at + 1)] * scale;
            var bZ:Number = boxesB[int(at + 2)] * scale;
            pair.bX = boxesB[int(at + 3)] * scale;
            pair.bY = boxesB[int(at + 4)] * scale;
            pair.bZ = boxesB[int(at + 5)] * scale;
            at = 6 * a;
            pair.x = relative.r00 * bX + relative.r01 * bY + relative.r02 * bZ + relative.x - boxesA[at];
            pair.y = relative.r10 * bX + relative.r11 * bY + relative.r12 * bZ + relative.y - boxesA[int(at + 1)];
            pair.z = relative.r20 * bX + relative.r21 * bY + relative.r22 * bZ + relative.z - boxesA[int(at + 2)];
            pair.aX = boxesA[int(at + 3)];
            pair.aY = boxesA[int(at + 4)];
            pair.aZ = boxesA[int(at + 5)];
            pair.latest = out.least < _latest ? out.least : _latest;
            if (withEdges)
            {
                _sweep.findTime(pair);
            }
            else
            {
                _sweep.findTimeOfFaces(pair);
            }
            out.current = pair.time;
        }
    }
}
