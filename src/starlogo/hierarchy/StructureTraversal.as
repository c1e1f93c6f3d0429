package starlogo.hierarchy
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.bounding.Capsule;
    import starlogo.bounding.Sphere;
    import starlogo.engine;
    import starlogo.intersection.intersects;
    import starlogo.intersection.sweep.RelativeMotion;
    import starlogo.intersection.sweep.findTimeOfImpact;

    use namespace engine;

    /**
     * Decides whether two trees of any structures overlap, or a tree and a single structure, or when they first touch. It uses the pair
     * tests of their kinds. BoxTraversal is faster for boxes.
     *
     * <p>A child's sphere may extend beyond its parent's, so a structure can meet the child without meeting the parent. Still a greater
     * depth never finds more collisions. This is because all depths reach the nodes in one order, a level of the first tree and then a
     * level of the second (thesis §4.6), and only through ancestors that overlap. Below the last level of one tree, the cover of a node
     * stands for all its descendants. For moving models, a pair is tested only in the interval in which its ancestors touch.</p>
     *
     * @private
     */
    public final class StructureTraversal extends NodePairTraversal
    {
        private var _part:RelativeMotion = new RelativeMotion();

        private var _pair:NodePair;

        /** @inheritDoc */
        public function StructureTraversal(pose:RelativePose, isSwept:Boolean)
        {
            super(pose, isSwept);
            _pair = new NodePair(pose);
        }

        /** @inheritDoc */
        override protected function beginRoots(a:HierarchyNode, b:HierarchyNode):void
        {
            _pair.begin();
        }

        /** @inheritDoc */
        override protected function visit(a:HierarchyNode, aEnds:Boolean, b:HierarchyNode, bEnds:Boolean):int
        {
            nodeVisits++;
            _pair.place(a, b);
            var structureA:BoundingStructure = _pair.a;
            var moved:BoundingStructure = _pair.b;
            if (isSwept)
            {
                if (!isInTime(structureA, moved))
                {
                    return APART;
                }
            }
            else if (!intersects(structureA, moved))
            {
                return APART;
            }
            if (aEnds && bEnds)
            {
                return TOUCHING;
            }
            // A single structure against a tree of boxes needs no end. A box contains its children's boxes, and a structure that leaves one
            // box may still meet another.
            if (isSwept && (b.level > 0 || structureA.kind != BoundingStructure.BOX))
            {
                findEnd(structureA, moved);
            }
            if (!bEnds && (aEnds || a.level > b.level))
            {
                return LEFT_OF_B;
            }
            return !isSwept && isRightNearer(a, moved) ? RIGHT_OF_A : LEFT_OF_A;
        }

        // Whether structures touch in the interval of their pair, and before <code>time</code>. Sets the beginning of the interval to the
        // first moment at which they touch.
        private function isInTime(a:BoundingStructure, b:BoundingStructure):Boolean
        {
            sweep(a, b, false);
            var share:Number = _part.time;
            from += (to - from) * share;
            otherFrom = from;
            return share <= 1 && from < time;
        }

        // Sets the end of the interval to the last time at which they touch. That is the first time of the motion backwards.
        private function findEnd(a:BoundingStructure, b:BoundingStructure):void
        {
            sweep(a, b, true);
            var share:Number = _part.time;
            to = share <= 1 ? to - (to - from) * share : from;
        }

        // Finds when structures touch, as a share of the interval of their pair, forwards or backwards.
        private function sweep(a:BoundingStructure, b:BoundingStructure, isBack:Boolean):void
        {
            var motion:RelativeMotion = pose.motion;
            var start:Number = isBack ? to : from;
            var share:Number = isBack ? from - to : to - from;
            _part.startX = motion.startX + start * motion.x;
            _part.startY = motion.startY + start * motion.y;
            _part.startZ = motion.startZ + start * motion.z;
            _part.x = share * motion.x;
            _part.y = share * motion.y;
            _part.z = share * motion.z;
            findTimeOfImpact(b, a, _part);
        }

        // Whether a structure is on the right child's side of a node's middle.
        private static function isRightNearer(node:HierarchyNode, structure:BoundingStructure):Boolean
        {
            var at:Vector3D;
            var end:Vector3D;
            if (structure.kind == BoundingStructure.SPHERE)
            {
                var sphere:Sphere = Sphere(structure);
                at = end = sphere.center;
            }
            else if (structure.kind == BoundingStructure.CAPSULE)
            {
                var capsule:Capsule = Capsule(structure);
                at = capsule.start;
                end = capsule.end;
            }
            else
            {
                var box:Box = Box(structure);
                at = end = box.center;
            }
            if (node.splitAxis == 0)
            {
                return at.x + end.x - 2 * node.x > 0;
            }
            if (node.splitAxis == 1)
            {
                return at.y + end.y - 2 * node.y > 0;
            }
            return at.z + end.z - 2 * node.z > 0;
        }
    }
}
