package starlogo.solid
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.convex.RelativeMotion;
    import starlogo.hierarchy.BoxSearch;
    import starlogo.hierarchy.BoxTree;
    import starlogo.hierarchy.NodeVisitor;
    import starlogo.hierarchy.TreeCounts;
    import starlogo.intersection.StructurePairs;

    /**
     * Decides when a structure first touches the boxes of a tree, and whether it does if it is still (thesis §5.2). The kernel of the two tests
     * a leaf.
     */
    internal final class NodeImpactVisitor extends NodeVisitor
    {
        // Finds the nodes near the structure.
        private var _search:BoxSearch;

        private var _structure:BoundingStructure;

        // The structure's motion, which has the times of the current node. The node that is touched first.
        private var _motion:RelativeMotion;
        private var _found:int = -1;

        private var _extents:Vector.<Number> = new Vector.<Number>(6, true);

        /** @param counts counts the nodes that are visited */
        public function NodeImpactVisitor(counts:TreeCounts)
        {
            _search = new BoxSearch(counts);
        }

        /**
         * Finds when a structure first touches a leaf of the search, and which one.
         *
         * @param depth how many of the tree's levels are visited
         * @param structure in the tree's space, enlarged by the margin of its place
         * @param motion of the structure; receives the time, and its latest time is overwritten. If it is still, the
         *     structure touches at time 0 or never
         * @return the leaf, or -1
         */
        public function findFirstNode(tree:BoxTree, depth:int, structure:BoundingStructure, motion:RelativeMotion):int
        {
            _structure = structure;
            _motion = motion;
            _found = -1;
            limit = motion.latestTime;
            _structure.extentsInto(_extents);
            _search.setExtents(_extents, 0);
            _search.setMotion(motion);
            _search.visitMet(tree, depth, this);
            // a search that has ended early has found a touch at time 0
            motion.time = _found < 0 ? RelativeMotion.NEVER : Math.max(0, limit);
            return _found;
        }

        /** @inheritDoc */
        override public function visit(tree:BoxTree, node:int):void
        {
            var box:Box = tree.boxOf(node);
            var motion:RelativeMotion = _motion;
            if (motion.isStill)
            {
                motion.time = StructurePairs.areTouching(box, _structure) ? 0 : RelativeMotion.NEVER;
            }
            else
            {
                motion.latestTime = limit;
                StructurePairs.findTimeOfImpact(_structure, box, motion);
            }
            if (motion.time < limit || _found < 0 && motion.time == limit)
            {
                _found = node;
                limit = motion.time;
                if (!(limit > 0))
                {
                    // nothing is touched earlier than at the beginning
                    endSearch();
                }
            }
        }
    }
}
