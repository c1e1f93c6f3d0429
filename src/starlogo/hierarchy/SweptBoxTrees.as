package starlogo.hierarchy
{
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.geometry.Tolerances;
    import starlogo.intersection.sweep.BoxSweep;
    import starlogo.intersection.sweep.RelativeMotion;

    use namespace engine;

    /**
     * Decides when two trees of boxes touch that pass each other: the first moment at which two nodes that are leaves or at their depth
     * limit do. Parents touch no later than their children, so a pair that comes later than one that was found is left out, and of
     * two children the one that comes first is looked at first.
     */
    internal final class SweptBoxTrees
    {
        /** Pairs of nodes that were visited; SweptHierarchyTraversal sets it to 0. */
        public var nodeVisits:int = 0;

        /** The nodes that touched first, if any did. */
        public var firstA:HierarchyNode = null;

        /** @copy #firstA */
        public var firstB:HierarchyNode = null;

        private var _pose:RelativePose;
        private var _sweep:BoxSweep = new BoxSweep();
        private var _rounding:Number;

        // Pairs of nodes, and when they begin not to be separated by any face.
        private var _nodes:Vector.<HierarchyNode> = new Vector.<HierarchyNode>();
        private var _times:Vector.<Number> = new Vector.<Number>();
        private var _top:int;

        /**
         * @param pose where the second model is in the space of the first at time 0, whenever two are asked about
         */
        public function SweptBoxTrees(pose:RelativePose)
        {
            _pose = pose;
        }

        /**
         * When two nodes that are leaves or at their depth limit touch.
         *
         * @param a the root of the first model's hierarchy
         * @param depthA how many levels of it are visited
         * @param b the root of the second model's
         * @param depthB how many levels of that are visited
         * @param x the way of the second in the space of the first
         * @param y likewise
         * @param z likewise
         * @param exact decides in place of such nodes that touch, or null
         * @return from 0 to 1, or RelativeMotion.NEVER
         */
        public function touch(a:HierarchyNode, depthA:int, b:HierarchyNode, depthB:int, x:Number, y:Number, z:Number,
                exact:SweptPairTest):Number
        {
            var relative:Placement = _pose.placement;
            var scale:Number = relative.size;
            _sweep.turn(relative.r00, relative.r01, relative.r02, relative.r10, relative.r11, relative.r12, relative.r20, relative.r21,
                    relative.r22);
            _sweep.move(x, y, z);
            _rounding = _pose.gap + Tolerances.ROUNDING * (Math.abs(relative.x) + Math.abs(relative.y) + Math.abs(relative.z) + Math.abs(x)
                    + Math.abs(y) + Math.abs(z));
            firstA = firstB = null;
            _top = 0;
            var earliest:Number = RelativeMotion.NEVER;
            push(a, b, facesMeet(a, b, 1));
            while (_top > 0)
            {
                _top -= 2;
                var time:Number = _times[_top >> 1];
                if (time >= earliest)
                {
                    continue;
                }
                a = _nodes[_top];
                b = _nodes[int(_top + 1)];
                var aEnds:Boolean = a.cutoffLevel >= depthA;
                var bEnds:Boolean = b.cutoffLevel >= depthB;
                var latest:Number = earliest < 1 ? earliest : 1;
                if (aEnds && bEnds)
                {
                    time = exact != null ? exact.leavesTouch(a, b, latest) : boxesMeet(a, b, latest);
                    if (time < earliest)
                    {
                        earliest = time;
                        firstA = a;
                        firstB = b;
                        if (time == 0)
                        {
                            return 0;
                        }
                    }
                }
                else if (bEnds || (!aEnds && a.radius >= scale * b.radius))
                {
                    pushBoth(a.left, b, a.right, b, latest);
                }
                else
                {
                    pushBoth(a, b.left, a, b.right, latest);
                }
            }
            return earliest;
        }

        // The one that comes first last.
        private function pushBoth(a:HierarchyNode, b:HierarchyNode, otherA:HierarchyNode, otherB:HierarchyNode, latest:Number):void
        {
            var time:Number = facesMeet(a, b, latest);
            var otherTime:Number = facesMeet(otherA, otherB, latest);
            if (time < otherTime)
            {
                push(otherA, otherB, otherTime);
                push(a, b, time);
            }
            else
            {
                push(a, b, time);
                push(otherA, otherB, otherTime);
            }
        }

        private function push(a:HierarchyNode, b:HierarchyNode, time:Number):void
        {
            if (time == RelativeMotion.NEVER)
            {
                return;
            }
            _nodes[_top] = a;
            _nodes[int(_top + 1)] = b;
            _times[_top >> 1] = time;
            _top += 2;
        }

        private function facesMeet(a:HierarchyNode, b:HierarchyNode, latest:Number):Number
        {
            nodeVisits++;
            return meet(a, b, latest, false);
        }

        private function boxesMeet(a:HierarchyNode, b:HierarchyNode, latest:Number):Number
        {
            return meet(a, b, latest, true);
        }

        private function meet(a:HierarchyNode, b:HierarchyNode, latest:Number, withEdges:Boolean):Number
        {
            var relative:Placement = _pose.placement;
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
            var time:Number = _sweep.facesMeet(x, y, z, a.halfX, a.halfY, a.halfZ, bX, bY, bZ, _rounding, latest);
            if (withEdges && time != RelativeMotion.NEVER)
            {
                time = _sweep.edgesMeet(x, y, z, a.halfX, a.halfY, a.halfZ, bX, bY, bZ, _rounding);
            }
            return time;
        }
    }
}
