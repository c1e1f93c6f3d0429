package starlogo.solid
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.geometry.Tolerances;
    import starlogo.hierarchy.BoxTraversal;
    import starlogo.hierarchy.HierarchyNode;
    import starlogo.hierarchy.NodePairTraversal;
    import starlogo.hierarchy.RelativePose;
    import starlogo.hierarchy.StructureTraversal;
    import starlogo.hierarchy.UprightBoxTraversal;

    use namespace engine;

    /**
     * Decides whether two hierarchies collide, or one and a structure (thesis §4.6): depth-first, until two nodes that are
     * leaves or at their depth limit overlap; and if none do, whether a part of one is inside of the other.
     *
     * <p>The thesis puts both structures into the world for each pair of nodes (§4.5). Here one RelativePose for each pair of
     * agents takes the second model into the space of the first, and the traversal for what the hierarchies are made of does
     * the rest: an UprightBoxTraversal, a BoxTraversal or a StructureTraversal, with an ExactPairTest where triangles decide.</p>
     *
     * <p>Answers are nested: what triangles find, nodes find at any depth, and a greater depth finds no more than a smaller one.
     * Nodes alone would not do for solids: the leaves hug the surface, and a model well inside of a closed one meets none of
     * them. Hence the ContainmentTest, whose answer no depth changes.</p>
     *
     * <p>Nothing is allocated once the stacks have grown and the models' triangles were prepared.</p>
     *
     * @private
     */
    public final class HierarchyTraversal
    {
        private var _pose:RelativePose = new RelativePose();
        private var _uprightBoxes:UprightBoxTraversal;
        private var _boxes:BoxTraversal;
        private var _structures:StructureTraversal;
        private var _exact:ExactPairTest;
        private var _triangles:StructureTriangles;
        private var _containment:ContainmentTest;

        // Stands for a structure: a box in the space of its axes, or any.
        private var _leaf:HierarchyNode = new HierarchyNode();

        /** Nothing counted yet. */
        public function HierarchyTraversal()
        {
            _uprightBoxes = new UprightBoxTraversal(_pose);
            _boxes = new BoxTraversal(_pose);
            _structures = new StructureTraversal(_pose, false);
            _exact = new ExactPairTest(_pose);
            _triangles = new StructureTriangles(_pose);
            _containment = new ContainmentTest(_pose);
            _leaf.x = _leaf.y = _leaf.z = 0;
        }

        /** Pairs of nodes that were visited since resetCounts. */
        public function get nodeVisits():int
        {
            return _uprightBoxes.nodeVisits + _boxes.nodeVisits + _structures.nodeVisits;
        }

        /** Pairs of triangles that were tested since resetCounts. */
        public function get triangleTests():int
        {
            return _exact.triangleTests;
        }

        /** Begins to count. */
        public function resetCounts():void
        {
            _uprightBoxes.nodeVisits = _boxes.nodeVisits = _structures.nodeVisits = 0;
            _exact.triangleTests = 0;
        }

        /**
         * Whether two models collide by their hierarchies.
         *
         * @param a the first model's hierarchy
         * @param placementA where the first model stands
         * @param depthA how many levels of it are visited
         * @param b the second model's hierarchy
         * @param placementB where the second model stands
         * @param depthB how many levels of that are visited
         * @param exact whether, for two hierarchies of triangles, depths do not count and triangles decide
         */
        public function hierarchiesOverlap(a:SolidHierarchy, placementA:Placement, depthA:int, b:SolidHierarchy, placementB:Placement,
                depthB:int, exact:Boolean):Boolean
        {
            _pose.relate(placementA, placementB);
            var decider:ExactPairTest = null;
            if (exact && _exact.prepare(a, b))
            {
                decider = _exact;
                depthA = depthB = int.MAX_VALUE;
            }
            var traversal:NodePairTraversal = _structures;
            if (decider != null || a.boundsKind == BoundingStructure.BOX && b.boundsKind == BoundingStructure.BOX)
            {
                traversal = _pose.isUpright ? _uprightBoxes : _boxes;
            }
            // whose roots do not overlap, as of most that are close and do not collide, are not inside of each other
            return traversal.find(a.root, depthA, b.root, depthB, decider)
                || ((traversal.rootsOverlapped || decider != null) && _containment.isOneInside(a, b));
        }

        /**
         * Whether a model's hierarchy collides with a structure.
         *
         * @param a the model's hierarchy
         * @param placementA where the model stands
         * @param depth how many levels of it are visited
         * @param structure represents another model, in that model's space
         * @param placementB where the other model stands
         * @param exact whether, for a hierarchy of triangles, depths do not count and triangles decide: whether one meets the solid structure
         */
        public function structureOverlaps(a:SolidHierarchy, placementA:Placement, depth:int, structure:BoundingStructure,
                placementB:Placement, exact:Boolean = false):Boolean
        {
            _pose.relate(placementA, placementB);
            var decider:StructureTriangles = null;
            if (exact && _triangles.prepare(a, structure))
            {
                decider = _triangles;
                depth = int.MAX_VALUE;
            }
            if (structure.kind != BoundingStructure.BOX || decider == null && a.boundsKind != BoundingStructure.BOX)
            {
                if (_leaf.structure !== structure)
                {
                    _leaf.structure = structure;
                }
                return _structures.find(a.root, depth, _leaf, 1, decider)
                    || ((_structures.rootsOverlapped || decider != null) && _containment.isStructureInside(a, structure));
            }
            setLeaf(Box(structure));
            _pose.relateToAxesOf(Box(structure));
            return _boxes.find(a.root, depth, _leaf, 1, decider)
                || ((_boxes.rootsOverlapped || decider != null) && _containment.isLeafInside(a, _leaf));
        }

        // The box, as wide as a node's would be, in the space of its axes.
        private function setLeaf(box:Box):void
        {
            var middle:Vector3D = box.center;
            var distance:Number = Math.abs(middle.x) + Math.abs(middle.y) + Math.abs(middle.z);
            var margin:Number = Tolerances.ROUNDING * (box.halfX + box.halfY + box.halfZ + distance);
            _leaf.setHalfExtents(box.halfX + margin, box.halfY + margin, box.halfZ + margin);
        }
    }
}
