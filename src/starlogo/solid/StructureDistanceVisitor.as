package starlogo.solid
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.convex.ClosestPoints;
    import starlogo.engine;
    import starlogo.hierarchy.BoxSearch;
    import starlogo.hierarchy.BoxTree;
    import starlogo.hierarchy.NodeVisitor;
    import starlogo.hierarchy.TreeCounts;
    import starlogo.intersection.StructurePairs;
    import starlogo.intersection.TriangleKernel;

    use namespace engine;

    /**
     * Finds the distance of a solid structure from a model: from the boxes of its tree, visited to a depth, or from its triangles. The results are nested, as
     * those of DistanceTraversal.
     */
    internal final class StructureDistanceVisitor extends NodeVisitor
    {
        // Finds the nodes near the structure's extents: minX, maxX, minY, ...
        private var _search:BoxSearch;
        private var _extents:Vector.<Number> = new Vector.<Number>(6, true);

        private var _counts:TreeCounts;

        // The closest points so far.
        private var _nearest:ClosestPoints;

        // Whether triangles decide. If they do: the kernel, a triangle's corners, and the index of the nearest triangle.
        private var _isExact:Boolean = false;
        private var _kernel:TriangleKernel;
        private var _corners:Vector.<Number> = new Vector.<Number>(9, true);
        private var _found:int = -1;

        // If boxes decide: the structure, and the closest points of the current node.
        private var _structure:BoundingStructure;
        private var _measured:ClosestPoints = new ClosestPoints();

        /**
         * @param kernel has the structure as its shape
         * @param counts counts the nodes that are visited and the triangles that are tested
         */
        public function StructureDistanceVisitor(kernel:TriangleKernel, counts:TreeCounts)
        {
            _kernel = kernel;
            _counts = counts;
            _search = new BoxSearch(counts);
        }

        /**
         * Finds the distance and the closest points of a model and a structure.
         *
         * @param depth how many of the tree's levels are visited; BoxTree.EXACT if the triangles decide
         * @param structure in the model's space; enlarged by the margin of its place if boxes decide
         * @param out receives them, in the model's space, the model's point first
         * @return the index of the nearest triangle; -1 if boxes decide
         */
        public function find(model:ModelTree, depth:int, structure:BoundingStructure, out:ClosestPoints):int
        {
            structure.extentsInto(_extents);
            _isExact = depth == BoxTree.EXACT;
            _structure = structure;
            _nearest = out;
            _found = -1;
            limit = out.distance = Infinity;
            _search.setExtents(_extents, 0);
            _search.visitNear(model.treeFor(depth), depth, this);
            if (_found >= 0)
            {
                // the kernel has the structure's point first
                out.swap();
            }
            return _found;
        }

        /** @inheritDoc */
        override public function visit(tree:BoxTree, node:int):void
        {
            if (!_isExact)
            {
                measureBox(tree, node);
                return;
            }
            var end:int = tree.endPrimitive[node];
            for (var i:int = tree.firstPrimitive[node]; i < end && limit > 0; i++)
            {
                if (areExtentsWithin(limit, _extents, tree, i))
                {
                    _counts.triangleTests++;
                    tree.readTriangle(i, _corners);
                    if (_kernel.findCloser(_corners, _nearest))
                    {
                        limit = _nearest.distance;
                        _found = i;
                    }
                }
            }
        }

        private function measureBox(tree:BoxTree, node:int):void
        {
            var extents:Vector.<Number> = _extents;
            // the radius of the tree, and half of the structure's extents: the rounding error is relative to them
            var radii:Number = tree.boundingRadius + (extents[1] - extents[0]) / 2 + (extents[3] - extents[2]) / 2 + (extents[5] - extents[4]) / 2;
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
