package starlogo.solid
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.convex.ClosestPoints;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.hierarchy.BoxTraversal;
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

        /** Whether two standing models overlap. */
        public function areOverlapping(pair:TreePair):Boolean
        {
            var a:SolidHierarchy = pair.a;
            var b:SolidHierarchy = pair.b;
            var pose:RelativePose = _pose;
            pose.relate(pair.placementA, pair.placementB);
            if (b == null)
            {
                return overlapsStructure(pair);
            }
            var decider:LeafTest = pair.isExact ? _trianglePairs.begin(a, b, pose) : null;
            // If the roots do not overlap, neither model is inside of the other. This holds for most models that are close but do not collide.
            return _boxes.find(pose, a.tree, pair.depthA, b.tree, pair.depthB, decider)
                || ((_boxes.rootsOverlapped || decider != null) && isOneInside(pair));
        }

        // Whether the first model overlaps the structure that stands for the second one.
        private function overlapsStructure(pair:TreePair):Boolean
        {
            if (pair.isExact)
            {
                return touchesTriangle(pair.a, pair.structureB) || isOneInside(pair);
            }
            _leaf.begin(pair.structureB, _pose);
            return _boxes.find(_leaf.pose, pair.a.tree, pair.depthA, _leaf.tree, pair.depthB, _leaf.decider)
                || ((_boxes.rootsOverlapped || _leaf.decider != null) && isOneInside(pair));
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
            if (isOneInside(pair))
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

        private function isOneInside(pair:TreePair):Boolean
        {
            return pair.b == null ? _containment.isStructureInside(pair.a, pair.structureB, _pose) : _containment.isOneInside(pair.a, pair.b, _pose);
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
