package starlogo.solid
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.convex.ClosestPoints;
    import starlogo.hierarchy.BoxSearch;
    import starlogo.hierarchy.BoxTree;
    import starlogo.hierarchy.NodeVisitor;
    import starlogo.hierarchy.TreeCounts;
    import starlogo.intersection.TriangleKernel;

    /** Finds the distance of a solid structure from the triangles of a model. */
    internal final class TriangleDistanceVisitor extends NodeVisitor
    {
        // Finds the nodes near the structure's extents: minX, maxX, minY, ...
        private var _search:BoxSearch;
        private var _extents:Vector.<Number> = new Vector.<Number>(6, true);

        private var _counts:TreeCounts;
        private var _kernel:TriangleKernel;
        private var _corners:Vector.<Number> = new Vector.<Number>(9, true);

        // The closest points so far, and the index of their triangle.
        private var _nearest:ClosestPoints;
        private var _found:int = -1;

        /**
         * @param kernel has the structure as its shape
         * @param counts counts the nodes that are visited and the triangles that are tested
         */
        public function TriangleDistanceVisitor(kernel:TriangleKernel, counts:TreeCounts)
        {
            _kernel = kernel;
            _counts = counts;
            _search = new BoxSearch(counts);
        }

        /**
         * Finds the distance and the closest points of a model and a structure.
         *
         * @param tree the model's, with its triangles' corners listed
         * @param structure in the model's space
         * @param out receives them, in the model's space, the model's point first
         * @return the index of the nearest triangle; -1 if rounding leaves none
         */
        public function findClosest(tree:BoxTree, structure:BoundingStructure, out:ClosestPoints):int
        {
            structure.extentsInto(_extents);
            _nearest = out;
            _found = -1;
            limit = out.distance = Infinity;
            _search.setExtents(_extents, 0);
            _search.visitNear(tree, BoxTree.EXACT, this);
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
    }
}
