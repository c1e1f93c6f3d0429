package starlogo.collision
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.engine;
    import starlogo.geometry.Tolerances;
    import starlogo.libraries.Hierarchy;
    import starlogo.libraries.HierarchyNode;

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
    internal final class HierarchyTraversal
    {
        private var _pairs:int = 0;
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

        /** Begins to count. */
        public function resetCounts():void
        {
            _pairs = 0;
            _uprightBoxes.nodeVisits = _boxes.nodeVisits = _structures.nodeVisits = 0;
            _exact.triangleTests = 0;
        }

        /** Reports the counts. */
        public function countInto(statistics:CollisionStatistics):void
        {
            statistics.hierarchyTests = _pairs;
            statistics.nodeVisits = _uprightBoxes.nodeVisits + _boxes.nodeVisits + _structures.nodeVisits;
            statistics.triangleTests = _exact.triangleTests;
        }

        /**
         * Whether two bodies meet of which one is hierarchical at least. The answer does not depend on their order.
         *
         * @param first a body
         * @param second another body
         * @param maxDepth how many levels are visited of those whose agents have no depth of their own; the root is one
         * @param exact whether, for two hierarchies of triangles, depths do not count, triangles decide, and a model inside
         *     of a closed one meets it
         */
        public function bodiesMeet(first:Body, second:Body, maxDepth:int, exact:Boolean):Boolean
        {
            var bodyA:Body = first;
            var bodyB:Body = second;
            if (first.serial > second.serial)
            {
                bodyA = second;
                bodyB = first;
            }
            _pairs++;
            if (!bodyA.isHierarchical)
            {
                return structureMeets(bodyB, bodyB.depth == 0 ? maxDepth : bodyB.depth, bodyA);
            }
            var depthA:int = bodyA.depth == 0 ? maxDepth : bodyA.depth;
            if (!bodyB.isHierarchical)
            {
                return structureMeets(bodyA, depthA, bodyB);
            }
            var depthB:int = bodyB.depth == 0 ? maxDepth : bodyB.depth;
            _pose.relate(bodyA.agent.placement, bodyB.agent.placement);
            var a:Hierarchy = bodyA.hierarchy;
            var b:Hierarchy = bodyB.hierarchy;
            var decider:ExactPairTest = null;
            if (exact && _exact.prepare(a, b))
            {
                decider = _exact;
                depthA = depthB = int.MAX_VALUE;
            }
            var meet:Boolean;
            if (a.boundsKind != BoundingStructure.BOX || b.boundsKind != BoundingStructure.BOX)
            {
                meet = _structures.meet(a.root, depthA, b.root, depthB, decider);
            }
            else if (_pose.isUpright)
            {
                meet = _uprightBoxes.meet(a.root, depthA, b.root, depthB, decider);
            }
            else
            {
                meet = _boxes.meet(a.root, depthA, b.root, depthB, decider);
            }
            return meet || (decider != null && decider.isOneInside(a, b));
        }

        // Whether a hierarchy meets the structure of another body.
        private function structureMeets(hierarchical:Body, depth:int, other:Body):Boolean
        {
            var a:Hierarchy = hierarchical.hierarchy;
            var structure:BoundingStructure = other.structure;
            _pose.relate(hierarchical.agent.placement, other.agent.placement);
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
