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

        /** @inheritDoc */
        override protected function begin(a:HierarchyNode, b:HierarchyNode):void
        {
            var relative:Placement = pose.placement;
            var motion:RelativeMotion = pose.motion;
            _sweep.axes.readAxes(relative, 1);
            _sweep.motionX = motion.x;
            _sweep.motionY = motion.y;
            _sweep.motionZ = motion.z;
            _sweep.gap = pose.gap + Tolerances.ROUNDING * (Math.abs(relative.x) + Math.abs(relative.y) + Math.abs(relative.z)
                    + Math.abs(motion.x) + Math.abs(motion.y) + Math.abs(motion.z));
        }

        /** @inheritDoc */
        override protected function estimate(a:HierarchyNode, b:HierarchyNode):void
        {
            sweep(a, b, false);
        }

        /** @inheritDoc */
        override protected function settle(a:HierarchyNode, b:HierarchyNode, leaves:LeafTest):void
        {
            if (leaves == null)
            {
                sweep(a, b, true);
                return;
            }
            leaves.least = least < 1 ? least : 1;
            bound = leaves.touch(a, b) ? leaves.least : RelativeMotion.NEVER;
        }

        // Sets the bound to the first time at which no face separates two boxes. If withEdges is true, no edge separates them then either.
        // If that time is not before the least time, sets the bound to RelativeMotion.NEVER.
        private function sweep(a:HierarchyNode, b:HierarchyNode, withEdges:Boolean):void
        {
            var boxes:BoxSweep = _sweep;
            var relative:Placement = pose.placement;
            var scale:Number = relative.size;
            var bX:Number = b.x * scale;
            var bY:Number = b.y * scale;
            var bZ:Number = b.z * scale;
            boxes.x = relative.r00 * bX + relative.r01 * bY + relative.r02 * bZ + relative.x - a.x;
            boxes.y = relative.r10 * bX + relative.r11 * bY + relative.r12 * bZ + relative.y - a.y;
            boxes.z = relative.r20 * bX + relative.r21 * bY + relative.r22 * bZ + relative.z - a.z;
            boxes.aX = a.halfX;
            boxes.aY = a.halfY;
            boxes.aZ = a.halfZ;
            boxes.bX = b.halfX * scale;
            boxes.bY = b.halfY * scale;
            boxes.bZ = b.halfZ * scale;
            boxes.latest = least < 1 ? least : 1;
            boxes.meetFaces();
            if (withEdges && boxes.time != RelativeMotion.NEVER)
            {
                boxes.meetEdges();
            }
            bound = boxes.time;
        }
    }
}
