package starlogo.hierarchy
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.convex.RelativeMotion;
    import starlogo.intersection.PairTable;

    /** Decides when a structure first touches the boxes of a tree. The kernel of the two decides about a node. @private */
    public final class NodeTouchVisitor extends TouchVisitor
    {
        private var _structure:BoundingStructure;
        private var _box:Box = BoxTree.newBox();

        /** @param counts counts the nodes that are visited */
        public function NodeTouchVisitor(counts:TreeCounts)
        {
            super(counts);
        }

        /**
         * Finds when a structure first touches a node that decides, and which one.
         *
         * @param depth how many of the tree's levels are visited
         * @param structure in the space of another model
         * @param pose the other model's pose in the tree's space
         * @param motion of the structure, from the pose on; receives the time. If it is still, the structure touches at time 0 or never
         * @return the node, or -1
         */
        public function findTouch(tree:BoxTree, depth:int, structure:BoundingStructure, pose:RelativePose, motion:RelativeMotion):int
        {
            _structure = pose.placeWidened(structure);
            _structure.extentsInto(extents);
            search.setExtents(extents, 0);
            setMotion(motion);
            return findFirst(tree, depth);
        }

        /** @inheritDoc */
        override public function visit(tree:BoxTree, node:int):void
        {
            if (sweep.isStill)
            {
                sweep.time = PairTable.areTouching(tree.writeBox(node, _box), _structure) ? 0 : RelativeMotion.NEVER;
            }
            else
            {
                PairTable.findTime(_structure, tree.writeBox(node, _box), sweep);
            }
            keepEarlier(node);
        }
    }
}
