package starlogo.solid
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.convex.ClosestPoints;
    import starlogo.convex.ContactPoint;
    import starlogo.convex.ConvexShape;
    import starlogo.convex.RelativeMotion;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.hierarchy.BoxTree;
    import starlogo.hierarchy.TreeCounts;
    import starlogo.intersection.StructurePairs;
    import starlogo.intersection.TriangleKernel;

    use namespace engine;

    /**
     * A placed tree a, and a placed structure that stands for b (thesis §5.2). A search visits the nodes near the structure. Their boxes
     * decide, or for exact tests their triangles: then the two overlap if a triangle touches the solid structure, or if the structure is inside of the
     * tree's closed surface.
     *
     * @private
     */
    public final class TreeStructureQuery extends TreeQuery
    {
        private var _tree:ModelTree = null;
        private var _depth:int = 0;
        private var _structure:BoundingStructure = null;

        private var _nodeImpact:NodeImpactVisitor;
        private var _nodeDistance:NodeDistanceVisitor;
        private var _triangleImpact:TriangleImpactVisitor;
        private var _triangleDistance:TriangleDistanceVisitor;

        // Has the structure in a's space as a shape.
        private var _kernel:TriangleKernel = new TriangleKernel();

        private var _measured:ClosestPoints = new ClosestPoints();

        /** @param counts counts what the questions take */
        public function TreeStructureQuery(counts:TreeCounts)
        {
            _nodeImpact = new NodeImpactVisitor(counts);
            _nodeDistance = new NodeDistanceVisitor(counts);
            _triangleImpact = new TriangleImpactVisitor(_kernel, counts);
            _triangleDistance = new TriangleDistanceVisitor(_kernel, counts);
        }

        /**
         * Sets the two.
         *
         * @param depth how many levels of the tree are visited; BoxTree.EXACT if its triangles decide
         * @param structure in b's space
         * @return this
         */
        public function setTo(tree:ModelTree, placementA:Placement, depth:int, structure:BoundingStructure, placementB:Placement):TreeQuery
        {
            _tree = tree;
            _depth = depth;
            _structure = structure;
            this.placementA = placementA;
            this.placementB = placementB;
            return this;
        }

        /** Finds the number of the triangle that is nearest to the structure, as the model counts them; -1 if triangles do not decide. */
        public function findNearestTriangle():int
        {
            pose.setBetween(placementA, placementB, RelativeMotion.NONE, 0);
            var index:int = _depth == BoxTree.EXACT ? _triangleDistance.findClosest(_tree.treeFor(_depth), placed(), _measured) : -1;
            return index < 0 ? -1 : _tree.boxTree.primitives[index];
        }

        /** @inheritDoc */
        override internal function areTouchingInPose(still:RelativeMotion):Boolean
        {
            return findFirstTouched(still) >= 0 || findInside(null);
        }

        /** @inheritDoc */
        override internal function findImpactInPose(motion:RelativeMotion, out:ContactPoint):void
        {
            var found:int = findFirstTouched(motion);
            if (out == null || found < 0)
            {
                return;
            }
            if (_depth == BoxTree.EXACT)
            {
                _triangleImpact.findContact(_tree.boxTree, found, motion, out);
                out.triangle = _tree.boxTree.primitives[found];
            }
            else
            {
                findContactOfNodes(found, 0, motion, out);
            }
        }

        // Finds which triangle, by its index, or else which node is touched first. Returns -1 if none is.
        private function findFirstTouched(motion:RelativeMotion):int
        {
            return _depth == BoxTree.EXACT
                ? _triangleImpact.findFirstTriangle(_tree.treeFor(_depth), placed(), pose, motion)
                : _nodeImpact.findFirstNode(_tree.boxTree, _depth, placedWidened(), motion);
        }

        // The structure in a's space. The next call overwrites it.
        private function placed():BoundingStructure
        {
            return _kernel.setStructure(_structure, pose.placement);
        }

        // The same, enlarged by the margin of the pose, because boxes decide. The shape is not enlarged.
        private function placedWidened():BoundingStructure
        {
            var structure:BoundingStructure = placed();
            structure.widen(pose.margin);
            return structure;
        }

        /** @inheritDoc */
        override internal function findContactOfNodes(nodeA:int, nodeB:int, motion:RelativeMotion, out:ContactPoint):void
        {
            StructurePairs.findContact(placed(), _tree.boxTree.boxOf(nodeA), motion, out);
        }

        /** @inheritDoc */
        override internal function findClosestOfSurfaces(out:ClosestPoints):void
        {
            if (_depth == BoxTree.EXACT)
            {
                _triangleDistance.findClosest(_tree.treeFor(_depth), placed(), out);
            }
            else
            {
                _nodeDistance.findClosest(_tree.boxTree, _depth, placedWidened(), out);
            }
        }

        /** A structure that does not touch the surface is inside if one point of it is. @inheritDoc */
        override internal function findInside(out:ClosestPoints):Boolean
        {
            // The search has set the shape. The origin of its points is inside of it. If it is round, a ball around that origin is inside too.
            var shape:ConvexShape = _kernel.shape;
            if (!_tree.isInside(shape.origin, shape.radius))
            {
                return false;
            }
            if (out != null)
            {
                out.setPoint(shape.origin);
                out.placePoints(placementA);
            }
            return true;
        }
    }
}
