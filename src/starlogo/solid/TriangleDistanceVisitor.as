package starlogo.solid
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.convex.ClosestPoints;
    import starlogo.engine;
    import starlogo.hierarchy.BoxSearch;
    import starlogo.hierarchy.BoxTree;
    import starlogo.hierarchy.NodeVisitor;
    import starlogo.hierarchy.TreeCounts;
    import starlogo.hierarchy.TriangleMesh;
    import starlogo.intersection.TriangleKernel;

    use namespace engine;

    /** Finds the distance of a solid structure from the triangles of a model. */
    internal final class TriangleDistanceVisitor extends NodeVisitor
    {
        // Finds the nodes near the structure's extents.
        private var _search:BoxSearch;
        private var _counts:TreeCounts;

        private var _mesh:TriangleMesh;
        private var _kernel:TriangleKernel;
        private var _corners:Vector.<Number> = new Vector.<Number>(9, true);

        // The structure's extents: minX, maxX, minY, ...
        private var _extents:Vector.<Number> = new Vector.<Number>(6, true);

        // The closest points so far, and the slot of the nearest triangle.
        private var _nearest:ClosestPoints;
        private var _slot:int = -1;

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
         * @param model the model; has triangles
         * @param structure in the model's space
         * @param out receives them, in the model's space
         * @return the slot of the nearest triangle
         */
        public function find(model:ModelTree, structure:BoundingStructure, out:ClosestPoints):int
        {
            _mesh = model.mesh;
            structure.extentsInto(_extents);
            _nearest = out;
            _slot = -1;
            limit = out.distance = Infinity;
            _search.setExtents(_extents, 0);
            _search.visitNear(model.boxTree, BoxTree.EXACT, this);
            if (_slot >= 0)
            {
                // the model's point first
                out.swap();
            }
            return _slot;
        }

        /** @inheritDoc */
        override public function visit(tree:BoxTree, node:int):void
        {
            var end:int = tree.endSlot[node];
            for (var i:int = tree.firstSlot[node]; i < end && limit > 0; i++)
            {
                if (areExtentsWithin(limit, _extents, _mesh, i))
                {
                    _counts.triangleTests++;
                    _mesh.readTriangle(i, _corners);
                    if (_kernel.findCloser(_corners, _nearest))
                    {
                        limit = _nearest.distance;
                        _slot = i;
                    }
                }
            }
        }
    }
}
