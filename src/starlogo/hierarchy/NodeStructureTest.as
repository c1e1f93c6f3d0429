package starlogo.hierarchy
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.convex.RelativeMotion;
    import starlogo.engine;
    import starlogo.intersection.PairTable;

    use namespace engine;

    /**
     * Decides whether a structure touches the boxes of a tree, or when it does so (thesis §5.2). The kernel of the two decides about a node.
     *
     * @private
     */
    public final class NodeStructureTest extends NodeTest
    {
        /** The node that the structure touches first; -1 if it touches none. */
        public var firstNode:int = -1;

        // Finds the nodes near the structure.
        private var _boxes:BoxSearch;

        private var _structure:BoundingStructure;
        private var _motion:RelativeMotion;
        private var _extents:Vector.<Number> = new Vector.<Number>(6, true);
        private var _box:Box = new Box(new Vector3D(), Vector3D.X_AXIS, Vector3D.Y_AXIS, Vector3D.Z_AXIS, 0, 0, 0);

        /** @param counts counts the nodes that are visited */
        public function NodeStructureTest(counts:TreeCounts)
        {
            _boxes = new BoxSearch(counts);
        }

        /**
         * Whether a structure touches a node that decides.
         *
         * @param depth how many of the tree's levels are visited
         * @param structure in the space of another model
         * @param pose the other model's pose in the tree's space
         */
        public function areTouching(tree:BoxTree, depth:int, structure:BoundingStructure, pose:RelativePose):Boolean
        {
            limit = 0;
            search(tree, depth, structure, pose, RelativeMotion.NONE);
            return firstNode >= 0;
        }

        /**
         * Finds when a moving structure first touches a node that decides. The other parameters are those of <code>areTouching()</code>.
         *
         * @param motion of the structure, from the pose on; receives the time
         */
        public function findTime(tree:BoxTree, depth:int, structure:BoundingStructure, pose:RelativePose, motion:RelativeMotion):void
        {
            limit = motion.latest;
            search(tree, depth, structure, pose, motion);
            var time:Number = limit > 0 ? limit : 0;
            motion.time = firstNode < 0 ? RelativeMotion.NEVER : time;
        }

        private function search(tree:BoxTree, depth:int, structure:BoundingStructure, pose:RelativePose, motion:RelativeMotion):void
        {
            _structure = pose.placeWidened(structure);
            _motion = motion;
            firstNode = -1;
            _structure.extentsInto(_extents);
            _boxes.setExtents(_extents, 0);
            _boxes.setMotion(motion);
            _boxes.find(tree, depth, this);
        }

        /** @inheritDoc */
        override public function testNode(tree:BoxTree, node:int):void
        {
            tree.writeBox(node, _box);
            var time:Number = 0;
            if (_motion.isStill)
            {
                time = PairTable.areTouching(_box, _structure) ? 0 : RelativeMotion.NEVER;
            }
            else
            {
                PairTable.findTime(_structure, _box, _motion);
                time = _motion.time;
            }
            if (time < limit || time == limit && firstNode < 0)
            {
                firstNode = node;
                // no node can be touched earlier than at the beginning
                limit = time > 0 ? time : -Infinity;
            }
        }
    }
}
