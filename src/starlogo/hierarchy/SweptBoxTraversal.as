package starlogo.hierarchy
{
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.geometry.Tolerances;
    import starlogo.intersection.sweep.BoxSweep;
    import starlogo.intersection.sweep.RelativeMotion;

    use namespace engine;

    /**
     * Decides when two trees of moving boxes first touch. Parents touch no later than their children. So the children of a pair are tested
     * when the pair is divided, and the child that touches first is visited first. The axes of the edges are tried only for pairs whose
     * boxes decide.
     *
     * @private
     */
    public final class SweptBoxTraversal extends NodePairTraversal
    {
        private var _sweep:BoxSweep = new BoxSweep();

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
            _sweep.xx = relative.r00;
            _sweep.xy = relative.r01;
            _sweep.xz = relative.r02;
            _sweep.yx = relative.r10;
            _sweep.yy = relative.r11;
            _sweep.yz = relative.r12;
            _sweep.zx = relative.r20;
            _sweep.zy = relative.r21;
            _sweep.zz = relative.r22;
            _sweep.motionX = motion.x;
            _sweep.motionY = motion.y;
            _sweep.motionZ = motion.z;
            _sweep.prepare();
            _sweep.gap = pose.gap + Tolerances.ROUNDING * (Math.abs(relative.x) + Math.abs(relative.y) + Math.abs(relative.z)
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
            sweep(dividesA ? a.low : a, dividesA ? b : b.low, false);
            var left:Number = from;
            sweep(dividesA ? a.high : a, dividesA ? b : b.high, false);
            if (left < from)
            {
                otherFrom = from;
                from = left;
                return dividesA ? LEFT_OF_A : LEFT_OF_B;
            }
            otherFrom = left;
            return dividesA ? RIGHT_OF_A : RIGHT_OF_B;
        }

        // Sets the field from to the first time at which no face separates two boxes. If withEdges is true, no edge separates them then either.
        // If that time is not before the field time, sets from to RelativeMotion.NEVER.
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
            boxes.latest = time < 1 ? time : 1;
            boxes.meetFaces();
            if (withEdges && boxes.time != RelativeMotion.NEVER)
            {
                boxes.meetEdges();
            }
            from = boxes.time;
        }
    }
}
