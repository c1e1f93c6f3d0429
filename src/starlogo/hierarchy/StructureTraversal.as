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
     * Decides whether a tree and a single structure overlap, or when they first touch, by the pair tests of boxes and the structure's kind. It
     * takes two trees too. BoxTraversal is faster for these, and for boxes. For moving models, a pair is tested only from the moment on at which its ancestors
     * touch.
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
            sweep(a, b);
            var share:Number = _part.time;
            from += (to - from) * share;
            otherFrom = from;
            return share <= 1 && from < time;
        }

        // Finds when structures touch, as a share of the interval of their pair.
        private function sweep(a:BoundingStructure, b:BoundingStructure):void
        {
            var motion:RelativeMotion = pose.motion;
            var share:Number = to - from;
            _part.startX = motion.startX + from * motion.x;
            _part.startY = motion.startY + from * motion.y;
            _part.startZ = motion.startZ + from * motion.z;
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
