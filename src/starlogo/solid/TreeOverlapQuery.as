package starlogo.solid
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.convex.ClosestPoints;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.hierarchy.BoxTraversal;
    import starlogo.hierarchy.BoxTree;
    import starlogo.hierarchy.LeafTest;
    import starlogo.hierarchy.RelativePose;
    import starlogo.hierarchy.StructureLeaf;

    use namespace engine;

    /**
     * Tests whether two standing models overlap: two trees, or a tree and a structure (thesis §4.6). Nothing is allocated once the stacks
     * have grown and the models' triangles are prepared.
     *
     * <p>The thesis transforms both structures into the world for each pair of nodes (§4.5). Here one RelativePose for each pair of models
     * transforms the second model into the first model's space. There a traversal of pairs of nodes decides, depth-first, down to two nodes
     * that are leaves or at their depth limit. A structure is a tree of one node. For exact tests, triangles decide about the leaves.</p>
     *
     * <p>The answers are nested. The leaves cover only the surface, so a ContainmentTest decides about a model inside a closed one.</p>
     *
     * @private
     */
    public final class TreeOverlapQuery
    {
        // Transforms the second model into the first model's space.
        private var _pose:RelativePose = new RelativePose();

        private var _boxes:BoxTraversal = new BoxTraversal();

        // The tests that decide about leaves.
        private var _leaf:StructureLeaf = new StructureLeaf();
        private var _trianglePairs:LeafOverlapTest = new LeafOverlapTest();
        private var _triangles:LeafStructureTest = new LeafStructureTest();
        private var _containment:ContainmentTest = new ContainmentTest();

        /** The number of pairs of nodes visited since resetCounts. */
        public function get nodeVisits():int
        {
            return _boxes.nodeVisits + _triangles.boxes.nodeVisits;
        }

        /** The number of pairs of triangles, or of a triangle and a structure, tested since resetCounts. */
        public function get triangleTests():int
        {
            return _trianglePairs.triangleTests + _triangles.triangleTests;
        }

        /** Sets all counts to 0. */
        public function resetCounts():void
        {
            _boxes.nodeVisits = _triangles.boxes.nodeVisits = 0;
            _trianglePairs.triangleTests = _triangles.triangleTests = 0;
        }

        /**
         * Whether two standing models overlap.
         *
         * <p>The arguments are no TreePair, because writing them to its fields is slow in comparison with the test of two models that are apart.</p>
         *
         * @param a the first model's hierarchy
         * @param placementA the first model's placement in the world
         * @param depthA how many levels of its hierarchy are visited
         * @param b the second model's hierarchy; null if a structure stands for that model
         * @param structureB that structure, in the second model's space; ignored if b is not null
         * @param placementB the second model's placement in the world
         * @param depthB how many levels of its hierarchy are visited
         * @param exact whether triangles decide in place of depths, if the trees have triangles. A tree and a structure collide if a triangle
         *     touches the solid structure, or if the structure is inside of the tree's closed surface
         */
        public function areOverlapping(a:SolidHierarchy, placementA:Placement, depthA:int, b:SolidHierarchy, structureB:BoundingStructure,
                placementB:Placement, depthB:int, exact:Boolean):Boolean
        {
            var pose:RelativePose = _pose;
            pose.relate(placementA, placementB);
            var decider:LeafTest = null;
            if (exact && a.hasTriangles && b == null)
            {
                return touchesTriangle(a, structureB) || isOneInside(a, null, structureB);
            }
            if (exact && a.hasTriangles && b.hasTriangles)
            {
                decider = _trianglePairs.begin(a, b, pose);
                depthA = depthB = int.MAX_VALUE;
            }
            var second:BoxTree;
            if (b != null)
            {
                second = b.tree;
            }
            else
            {
                _leaf.begin(structureB, pose);
                decider = _leaf.decider;
                pose = _leaf.pose;
                second = _leaf.tree;
            }
            // If the roots do not overlap, neither model is inside of the other. This holds for most models that are close but do not collide.
            return _boxes.find(pose, a.tree, depthA, second, depthB, decider)
                || ((_boxes.rootsOverlapped || decider != null) && isOneInside(a, b, structureB));
        }

        /**
         * Finds a point of two models that overlap although their measured distance is more than 0: one is inside of the other.
         *
         * @param out receives the point twice; left as it is if no such point is known
         * @return the placement of the model in whose space the points are
         */
        public function findCommonPoint(pair:TreePair, out:ClosestPoints):Placement
        {
            _pose.relate(pair.placementA, pair.placementB);
            if (isOneInside(pair.a, pair.b, pair.structureB))
            {
                out.setPoint(_containment.innerPoint);
                return _containment.isPointOfSecond ? pair.placementB : pair.placementA;
            }
            if (pair.isExact && pair.b == null && touchesTriangle(pair.a, pair.structureB))
            {
                // No triangle crosses the surface of the box. So the box is around the triangles that touch it.
                _leaf.begin(pair.structureB, _pose);
                _triangles.takeCorner(_leaf.moved, out);
            }
            return pair.placementA;
        }

        private function isOneInside(a:SolidHierarchy, b:SolidHierarchy, structureB:BoundingStructure):Boolean
        {
            return b == null ? _containment.isStructureInside(a, structureB, _pose) : _containment.isOneInside(a, b, _pose);
        }

        // Whether a triangle of a model touches a structure in the place of the second model.
        private function touchesTriangle(a:SolidHierarchy, structureB:BoundingStructure):Boolean
        {
            _triangles.begin(a, structureB, _pose);
            if (_triangles.isCompact)
            {
                return _triangles.find();
            }
            _leaf.begin(structureB, _pose);
            return _boxes.find(_leaf.pose, a.tree, int.MAX_VALUE, _leaf.tree, 1, _triangles);
        }
    }
}
