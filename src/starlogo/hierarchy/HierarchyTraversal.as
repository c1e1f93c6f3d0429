package starlogo.hierarchy
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.geometry.Tolerances;

    use namespace engine;

    /**
     * Decides whether two hierarchies meet, or one and a structure (thesis §4.6): depth-first, until two nodes that are
     * leaves or at their depth limit overlap.
     *
     * <p>The thesis puts both structures into the world for each pair of nodes (§4.5). Here one RelativePose for each pair of
     * agents takes the second model into the space of the first, and the traversal for what the hierarchies are made of does
     * the rest: UprightBoxTreeTraversal, BoxTreeTraversal or StructureTreeTraversal, with an ExactPairTest where triangles
     * decide.</p>
     *
     * <p>Scratch objects are reused: nothing is allocated once the stacks have grown.</p>
     */
    public final class HierarchyTraversal
    {
        private var _pose:RelativePose = new RelativePose();
        private var _uprightBoxes:UprightBoxTreeTraversal;
        private var _boxes:BoxTreeTraversal;
        private var _structures:StructureTreeTraversal;
        private var _exact:ExactPairTest;

        // A box that stands for a model, with its own axes.
        private var _leaf:HierarchyNode = new HierarchyNode();

        /** Nothing counted yet. */
        public function HierarchyTraversal()
        {
            _uprightBoxes = new UprightBoxTreeTraversal(_pose);
            _boxes = new BoxTreeTraversal(_pose);
            _structures = new StructureTreeTraversal(_pose);
            _exact = new ExactPairTest(_pose);
            _leaf.level = 1;
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
         * Whether two models' hierarchies overlap.
         *
         * @param a the first model's hierarchy
         * @param placementA where the first model stands
         * @param depthA how many levels of it are visited
         * @param b the second model's hierarchy
         * @param placementB where the second model stands
         * @param depthB how many levels of that are visited
         * @param exact whether, for two hierarchies of triangles, depths do not count, triangles decide, and a model inside
         *     of a closed one meets it
         */
        public function hierarchiesOverlap(a:Hierarchy, placementA:Placement, depthA:int, b:Hierarchy, placementB:Placement, depthB:int,
                exact:Boolean):Boolean
        {
            _pose.relate(placementA, placementB);
            var decider:ExactPairTest = null;
            if (exact && _exact.prepare(a, b))
            {
                decider = _exact;
                depthA = depthB = int.MAX_VALUE;
            }
            var overlap:Boolean;
            if (a.boundsKind != BoundingStructure.BOX || b.boundsKind != BoundingStructure.BOX)
            {
                overlap = _structures.meet(a.root, depthA, b.root, depthB, decider);
            }
            else if (_pose.isUpright)
            {
                overlap = _uprightBoxes.meet(a.root, depthA, b.root, depthB, decider);
            }
            else
            {
                overlap = _boxes.meet(a.root, depthA, b.root, depthB, decider);
            }
            return overlap || (decider != null && decider.isOneInside(a, b));
        }

        /**
         * Whether a model's hierarchy overlaps a structure.
         *
         * @param a the model's hierarchy
         * @param placementA where the model stands
         * @param depth how many levels of it are visited
         * @param structure stands for another model, in that one's space
         * @param placementB where the other model stands
         */
        public function structureOverlaps(a:Hierarchy, placementA:Placement, depth:int, structure:BoundingStructure,
                placementB:Placement):Boolean
        {
            _pose.relate(placementA, placementB);
            if (structure.kind == BoundingStructure.BOX && a.boundsKind == BoundingStructure.BOX)
            {
                var box:Box = structure as Box;
                _pose.relateToAxesOf(box);
                return _boxes.meet(a.root, depth, leafOf(box), 1, null);
            }
            return _structures.structureMeets(a.root, depth, structure);
        }

        // The box, as wide as a node's would be, in the space of its axes.
        private function leafOf(box:Box):HierarchyNode
        {
            var leaf:HierarchyNode = _leaf;
            var middle:Vector3D = box.center;
            var distance:Number = Math.abs(middle.x) + Math.abs(middle.y) + Math.abs(middle.z);
            var margin:Number = Tolerances.ROUNDING * (box.halfX + box.halfY + box.halfZ + distance);
            var halfX:Number = box.halfX + margin;
            var halfY:Number = box.halfY + margin;
            var halfZ:Number = box.halfZ + margin;
            leaf.halfX = halfX;
            leaf.halfY = halfY;
            leaf.halfZ = halfZ;
            leaf.radius = Math.sqrt(halfX * halfX + halfY * halfY + halfZ * halfZ);
            leaf.innerRadius = halfX < halfY ? halfX : halfY;
            if (halfZ < leaf.innerRadius)
            {
                leaf.innerRadius = halfZ;
            }
            return leaf;
        }
    }
}
