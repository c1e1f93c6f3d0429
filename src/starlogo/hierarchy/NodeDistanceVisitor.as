package starlogo.hierarchy
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.convex.ClosestPoints;
    import starlogo.intersection.StructurePairs;

    /** Finds the distance of a structure from the boxes of a tree. The results are nested, as those of DistanceTraversal. @private */
    public final class NodeDistanceVisitor extends NodeVisitor
    {
        // Finds the nodes near the structure.
        private var _search:BoxSearch;

        private var _structure:BoundingStructure;

        // The radius of the tree, and half of the structure's extents, together. The rounding error is relative to it.
        private var _radii:Number = 0;

        private var _measured:ClosestPoints = new ClosestPoints();
        private var _nearest:ClosestPoints;
        private var _extents:Vector.<Number> = new Vector.<Number>(6, true);

        /** @param counts counts the nodes that are visited */
        public function NodeDistanceVisitor(counts:TreeCounts)
        {
            _search = new BoxSearch(counts);
        }

        /**
         * Finds the distance and the closest points of a tree and a structure.
         *
         * @param depth how many of the tree's levels are visited
         * @param structure in the tree's space, enlarged by the margin of its place
         * @param out receives them, in the tree's space
         */
        public function find(tree:BoxTree, depth:int, structure:BoundingStructure, out:ClosestPoints):void
        {
            _structure = structure;
            _structure.extentsInto(_extents);
            _radii = tree.radius + (_extents[1] - _extents[0]) / 2 + (_extents[3] - _extents[2]) / 2 + (_extents[5] - _extents[4]) / 2;
            _search.setExtents(_extents, 0);
            _nearest = out;
            limit = out.distance = Infinity;
            _search.visitNear(tree, depth, this);
        }

        /** @inheritDoc */
        override public function visit(tree:BoxTree, node:int):void
        {
            StructurePairs.findClosest(tree.boxOf(node), _structure, _measured);
            DistanceTraversal.subtractSlack(_measured, tree.levelOf(node), 0, _radii);
            if (_measured.distance < limit)
            {
                limit = _measured.distance;
                _nearest.copyFrom(_measured);
            }
        }
    }
}
