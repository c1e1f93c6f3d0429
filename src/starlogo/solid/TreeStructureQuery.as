package starlogo.solid
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.convex.ClosestPoints;
    import starlogo.convex.ContactPoint;
    import starlogo.convex.ConvexShape;
    import starlogo.convex.RelativeMotion;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.hierarchy.BoxSearch;
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

        // Has the structure in a's space as a shape.
        private var _kernel:TriangleKernel = new TriangleKernel();

        // Used if triangles decide.
        private var _triangleSearch:StructureTriangleSearch;

        // Used if nodes decide: the search for leaves, the structure's extents (minX, maxX, minY, ...), and the closest points of a leaf.
        private var _search:BoxSearch;
        private var _extents:Vector.<Number> = new Vector.<Number>(6, true);
        private var _measured:ClosestPoints = new ClosestPoints();

        // A point of the structure.
        private var _point:Vector3D = new Vector3D();

        /** @param counts counts what the questions take */
        public function TreeStructureQuery(counts:TreeCounts)
        {
            _triangleSearch = new StructureTriangleSearch(_kernel, counts);
            _search = new BoxSearch(counts);
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
            var index:int = _depth == BoxTree.EXACT ? _triangleSearch.findNearest(_tree.treeFor(_depth), placed(), _measured) : -1;
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
                _triangleSearch.findContact(_tree.boxTree, found, motion, out);
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
            if (_depth != BoxTree.EXACT)
            {
                return findFirstNode(motion);
            }
            var structure:BoundingStructure = placed();
            _kernel.shape.margin += pose.margin;
            return _triangleSearch.findFirst(_tree.treeFor(_depth), structure, motion);
        }

        // Finds which leaf is touched first. Returns -1 if none is. What stands touches at time 0 or never.
        private function findFirstNode(motion:RelativeMotion):int
        {
            var tree:BoxTree = _tree.boxTree;
            var structure:BoundingStructure = placeInSearch();
            var isStill:Boolean = motion.isStill;
            var first:int = -1;
            _search.beginMet(tree, _depth, motion);
            var leaf:int = _search.nextMet();
            while (leaf >= 0)
            {
                var box:Box = tree.boxOf(leaf);
                if (isStill)
                {
                    motion.time = StructurePairs.areTouching(box, structure) ? 0 : RelativeMotion.NEVER;
                }
                else
                {
                    motion.latestTime = _search.limit;
                    StructurePairs.findTimeOfImpact(structure, box, motion);
                }
                if (motion.time < _search.limit || first < 0 && motion.time == _search.limit)
                {
                    first = leaf;
                    _search.limit = motion.time;
                }
                // nothing is touched earlier than at the beginning
                leaf = first < 0 || _search.limit > 0 ? _search.nextMet() : -1;
            }
            motion.time = first < 0 ? RelativeMotion.NEVER : _search.limit;
            return first;
        }

        // Returns the structure in a's space, enlarged by the margin of the pose because boxes decide, and sets the box of the search to its extents.
        // The kernel's shape is not enlarged.
        private function placeInSearch():BoundingStructure
        {
            var structure:BoundingStructure = placed();
            structure.widen(pose.margin);
            structure.extentsInto(_extents);
            _search.setExtents(_extents);
            return structure;
        }

        // The structure in a's space. The next call overwrites it.
        private function placed():BoundingStructure
        {
            return _kernel.setStructure(_structure, pose.placement);
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
                _triangleSearch.findNearest(_tree.treeFor(_depth), placed(), out);
            }
            else
            {
                findClosestOfNodes(out);
            }
        }

        // Finds the closest points of the structure and the leaves. The distances are nested, as those of DistanceTraversal.
        private function findClosestOfNodes(out:ClosestPoints):void
        {
            var tree:BoxTree = _tree.boxTree;
            var structure:BoundingStructure = placeInSearch();
            var extents:Vector.<Number> = _extents;
            // the radius of the tree, and half of the structure's extents: the rounding error is relative to them
            var radii:Number = tree.boundingRadius + (extents[1] - extents[0]) / 2 + (extents[3] - extents[2]) / 2 + (extents[5] - extents[4]) / 2;
            out.distance = Infinity;
            _search.beginNear(tree, _depth);
            for (var leaf:int = _search.nextNear(); leaf >= 0; leaf = _search.nextNear())
            {
                StructurePairs.findClosest(tree.boxOf(leaf), structure, _measured);
                DistanceTraversal.subtractNesting(_measured, tree.levelOf(leaf), 0, radii);
                if (_measured.distance < out.distance)
                {
                    out.copyFrom(_measured);
                    _search.limit = out.distance;
                }
            }
        }

        /** A structure that does not touch the surface is inside if one point of it is. @inheritDoc */
        override internal function findInside(out:ClosestPoints):Boolean
        {
            // The search has set the shape. The origin of its points is inside of it. If it is round, all its points are, with a ball around each: the
            // highest one is taken, because above a level there is mostly nothing.
            var shape:ConvexShape = _kernel.shape;
            var point:Vector3D = _point;
            point.copyFrom(shape.origin);
            if (shape.radius > 0)
            {
                var at:int = shape.support(Vector3D.Z_AXIS, 1);
                point.x += shape.points[at];
                point.y += shape.points[int(at + 1)];
                point.z += shape.points[int(at + 2)];
            }
            if (!_tree.isInside(point, shape.radius))
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
