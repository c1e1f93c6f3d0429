package starlogo.solid
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.convex.ClosestPoints;
    import starlogo.engine;
    import starlogo.hierarchy.BoxSearch;
    import starlogo.hierarchy.RelativePose;
    import starlogo.intersection.TriangleKernel;
    import starlogo.intersection.LeafTest;

    use namespace engine;

    /** Finds the distance of a solid structure from the triangles of a model. */
    internal final class TriangleDistanceTest extends LeafTest
    {
        /** Finds the leaves near the structure's extents. */
        public var boxes:BoxSearch = new BoxSearch();

        /** The number of triangles measured. The caller sets it to 0. */
        public var triangleTests:int = 0;

        private var _mesh:TriangleMesh;
        private var _test:TriangleKernel = new TriangleKernel();

        // The structure's extents: least x, greatest x, least y, ...
        private var _extents:Vector.<Number> = new Vector.<Number>(6, true);

        // The closest points so far, and the index of the nearest triangle in the tree's order.
        private var _nearest:ClosestPoints;
        private var _triangle:int = -1;

        /**
         * Finds the distance and the closest points of a model and a structure.
         *
         * @param model the model; has triangles
         * @param structure in the space of another model
         * @param pose the other model's pose in the first one's space
         * @param out receives them, in the model's space
         * @return the index of the nearest triangle in the tree's order
         */
        public function find(model:ModelTree, structure:BoundingStructure, pose:RelativePose, out:ClosestPoints):int
        {
            _mesh = model.mesh;
            _test.setStructure(structure, pose.placement);
            _test.structure.extentsInto(_extents);
            _nearest = out;
            _triangle = -1;
            least = out.distance = Infinity;
            boxes.setExtents(_extents, 0);
            boxes.findNear(model.tree, int.MAX_VALUE, this);
            out.swapShapes();
            return _triangle;
        }

        /** @inheritDoc */
        override public function testLeaf(node:int, first:int, end:int):void
        {
            for (var i:int = first; i < end && least > 0; i++)
            {
                if (squaredDistanceToExtents(_extents, _mesh.corners, 9 * i) < least * least)
                {
                    triangleTests++;
                    _test.setTriangle(_mesh.corners, 9 * i);
                    if (_test.findCloser(_nearest))
                    {
                        least = _nearest.distance;
                        _triangle = i;
                    }
                }
            }
        }
    }
}
