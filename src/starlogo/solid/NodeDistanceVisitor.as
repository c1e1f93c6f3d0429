package starlogo.solid
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.convex.ClosestPoints;
    import starlogo.hierarchy.BoxSearch;
    import starlogo.hierarchy.BoxTree;
    import starlogo.hierarchy.NodeVisitor;
    import starlogo.hierarchy.TreeCounts;
    import starlogo.intersection.StructurePairs;

    /** Finds the distance of a structure from the boxes of a tree. The results are nested, as those of DistanceTraversal. */
    internal final class NodeDistanceVisitor extends NodeVisitor
    {
        // Finds the nodes near the structure's extents: minX, maxX, minY, ...
        private var _search:BoxSearch;
        private var _extents:Vector.<Number> = new Vector.<Number>(6, true);

        private var _structure:BoundingStructure;

        // The closest points so far, and those of the current node.
        private var _nearest:ClosestPoints;
        private var _measured:ClosestPoints = new ClosestPoints();

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
         * @param out receives them, in the tree's space, the tree's point first
         */
        public function findClosest(tree:BoxTree, depth:int, structure:BoundingStructure, out:ClosestPoints):void
        {
            structure.extentsInto(_extents);
            _structure = structure;
            _nearest = out;
            limit = out.distance = Infinity;
            _search.setExtents(_extents, 0);
            _search.visitNear(tree, depth, this);
        }

        /** @inheritDoc */
        override public function visit(tree:BoxTree, node:int):void
        {
            // the radius of the tree, and half of the structure's extents: the rounding error is relative to them
            var radii:Number = tree.boundingRadius + (_extents[1] - _extents[0]) / 2 + (_extents[3] - _extents[2]) / 2 + (_extents[5] - _extents[4]) / 2;
            StructurePairs.findClosest(tree.boxOf(node), _structure, _measured);
            DistanceTraversal.subtractSlack(_measured, tree.levelOf(node), 0, radii);
            if (_measured.distance < limit)
            {
                limit = _measured.distance;
                _nearest.copyFrom(_measured);
            }
        }
    }
}
