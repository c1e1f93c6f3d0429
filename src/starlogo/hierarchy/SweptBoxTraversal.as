package starlogo.hierarchy
{
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.geometry.Tolerances;
    import starlogo.intersection.sweep.BoxSweep;
    import starlogo.intersection.sweep.RelativeMotion;

    use namespace engine;

    /**
     * Decides when two trees of boxes touch that pass each other. Parents touch no later than their children: the children of a
     * pair are tested when it is divided, and the one that touches first is visited first. The axes of edges are tried only where the boxes decide.
     *
     * @private
     */
    public final class SweptBoxTraversal extends NodePairTraversal
    {
        private var _sweep:BoxSweep = new BoxSweep();
        private var _rounding:Number;

        /** @inheritDoc */
        public function SweptBoxTraversal(pose:RelativePose)
        {
            super(pose, true);
        }

        /** @inheritDoc */
        override protected function beginRoots(a:HierarchyNode, b:HierarchyNode):void
        {
            var relative:Placement = pose.placement;
            var motion:RelativeMotion = pose.motion;
            _sweep.turn(relative.r00, relative.r01, relative.r02, relative.r10, relative.r11, relative.r12, relative.r20, relative.r21,
                    relative.r22);
            _sweep.move(motion.x, motion.y, motion.z);
            _rounding = pose.gap + Tolerances.ROUNDING * (Math.abs(relative.x) + Math.abs(relative.y) + Math.abs(relative.z)
                    + Math.abs(motion.x) + Math.abs(motion.y) + Math.abs(motion.z));
            nodeVisits++;
            sweep(a, b, false);
        }

        /** @inheritDoc */
        override protected function visit(a:HierarchyNode, aEnds:Boolean, b:HierarchyNode, bEnds:Boolean):int
        {
            if (aEnds && bEnds)
            {
                if (isByLeaves)
                {
                    return TOUCHING;
                }
                sweep(a, b, true);
                return from < time ? TOUCHING : APART;
            }
            nodeVisits += 2;
            var dividesA:Boolean = bEnds || (!aEnds && a.radius >= pose.placement.size * b.radius);
            sweep(dividesA ? a.left : a, dividesA ? b : b.left, false);
            var left:Number = from;
            sweep(dividesA ? a.right : a, dividesA ? b : b.right, false);
            if (left < from)
            {
                otherFrom = from;
                from = left;
                return dividesA ? LEFT_OF_A : LEFT_OF_B;
            }
            otherFrom = left;
            return dividesA ? RIGHT_OF_A : RIGHT_OF_B;
        }

        // Sets the time from which on no face separates two boxes, or no edges either, if that is before time; else RelativeMotion.NEVER.
        private function sweep(a:HierarchyNode, b:HierarchyNode, withEdges:Boolean):void
        {
            var latest:Number = time < 1 ? time : 1;
            var relative:Placement = pose.placement;
            var scale:Number = relative.size;
            var bX:Number = b.x * scale;
            var bY:Number = b.y * scale;
            var bZ:Number = b.z * scale;
            var x:Number = relative.r00 * bX + relative.r01 * bY + relative.r02 * bZ + relative.x - a.x;
            var y:Number = relative.r10 * bX + relative.r11 * bY + relative.r12 * bZ + relative.y - a.y;
            var z:Number = relative.r20 * bX + relative.r21 * bY + relative.r22 * bZ + relative.z - a.z;
            bX = b.halfX * scale;
            bY = b.halfY * scale;
            bZ = b.halfZ * scale;
            from = _sweep.facesMeet(x, y, z, a.halfX, a.halfY, a.halfZ, bX, bY, bZ, _rounding, latest);
            if (withEdges && from != RelativeMotion.NEVER)
            {
                from = _sweep.edgesMeet(x, y, z, a.halfX, a.halfY, a.halfZ, bX, bY, bZ, _rounding);
            }
        }
    }
}
