package starlogo.hierarchy
{
    import starlogo.convex.RelativeMotion;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.geometry.Tolerances;
    import starlogo.intersection.sweep.BoxSweep;

    use namespace engine;

    /**
     * Finds when two moving trees first touch, from time 0 to time 1. Parents touch no later than their children. The axes of the edges are
     * tried only for pairs whose boxes decide.
     *
     * @private
     */
    public final class SweptBoxTraversal extends NodePairTraversal
    {
        private var _sweep:BoxSweep = new BoxSweep();

        private var _pose:RelativePose;

        // The boxes of both trees.
        private var _boxesA:Vector.<Number>;
        private var _boxesB:Vector.<Number>;

        /** @param counts counts the pairs of nodes that are visited */
        public function SweptBoxTraversal(counts:TreeCounts)
        {
            super(counts);
        }

        /** @inheritDoc */
        override protected function begin(pose:RelativePose, a:BoxTree, b:BoxTree):void
        {
            _pose = pose;
            _boxesA = a.boxes;
            _boxesB = b.boxes;
            var relative:Placement = pose.placement;
            var motion:RelativeMotion = pose.motion;
            _sweep.axes.readAxes(relative, 1);
            _sweep.motionX = motion.x;
            _sweep.motionY = motion.y;
            _sweep.motionZ = motion.z;
            _sweep.tolerance = pose.tolerance + Tolerances.ROUNDING * (Math.abs(relative.x) + Math.abs(relative.y) + Math.abs(relative.z)
                    + Math.abs(motion.x) + Math.abs(motion.y) + Math.abs(motion.z));
        }

        /** @inheritDoc */
        override protected function estimate(a:int, b:int, out:NodePairBounds):void
        {
            sweep(a, b, false, out);
        }

        /** @inheritDoc */
        override protected function settle(treeA:BoxTree, a:int, treeB:BoxTree, b:int, leaves:LeafPairTest, out:NodePairBounds):void
        {
            if (leaves == null)
            {
                sweep(a, b, true, out);
                return;
            }
            leaves.least = out.least < 1 ? out.least : 1;
            out.current = leaves.testLeaves(treeA, a, treeB, b) ? leaves.least : RelativeMotion.NEVER;
        }

        // Sets the bound to the first time at which no face separates two boxes. If withEdges is true, no edge separates them then either.
        // If that time is after the least time, sets the bound to RelativeMotion.NEVER.
        private function sweep(a:int, b:int, withEdges:Boolean, out:NodePairBounds):void
        {
            var boxes:BoxSweep = _sweep;
            var relative:Placement = _pose.placement;
            var scale:Number = relative.size;
            var numbers:Vector.<Number> = _boxesB;
            var at:int = 6 * b;
            var bX:Number = numbers[at] * scale;
            var bY:Number = numbers[int(at + 1)] * scale;
            var bZ:Number = numbers[int(at + 2)] * scale;
            boxes.bX = numbers[int(at + 3)] * scale;
            boxes.bY = numbers[int(at + 4)] * scale;
            boxes.bZ = numbers[int(at + 5)] * scale;
            numbers = _boxesA;
            at = 6 * a;
            boxes.x = relative.r00 * bX + relative.r01 * bY + relative.r02 * bZ + relative.x - numbers[at];
            boxes.y = relative.r10 * bX + relative.r11 * bY + relative.r12 * bZ + relative.y - numbers[int(at + 1)];
            boxes.z = relative.r20 * bX + relative.r21 * bY + relative.r22 * bZ + relative.z - numbers[int(at + 2)];
            boxes.aX = numbers[int(at + 3)];
            boxes.aY = numbers[int(at + 4)];
            boxes.aZ = numbers[int(at + 5)];
            boxes.latest = out.least < 1 ? out.least : 1;
            boxes.meetFaces();
            if (withEdges && boxes.time != RelativeMotion.NEVER)
            {
                boxes.meetEdges();
            }
            out.current = boxes.time;
        }
    }
}
