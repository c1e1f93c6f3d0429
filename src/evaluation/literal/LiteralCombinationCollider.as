package evaluation.literal
{
    import starlogo.agents.Agent;
    import starlogo.bounding.BoundingStructure;
    import starlogo.hierarchy.HierarchyNode;
    import starlogo.libraries.HierarchiesLibrary;

    /**
     * The CombinationCollider as the thesis describes it (§5.2): two hierarchical agents by their hierarchies, two others by their tightest fits.
     * If one is hierarchical, its hierarchy is visited, and each node is tested with the other's tightest fit.
     */
    public final class LiteralCombinationCollider
    {
        private var _fits:LiteralTightestFitCollider;
        private var _trees:LiteralHierarchicalCollider;
        private var _library:HierarchiesLibrary;
        private var _maxDepth:int;

        /**
         * @param fits tests two agents that are not hierarchical
         * @param trees tests two that are
         * @param library has the hierarchies
         * @param maxDepth how many levels are visited
         */
        public function LiteralCombinationCollider(fits:LiteralTightestFitCollider, trees:LiteralHierarchicalCollider,
                library:HierarchiesLibrary, maxDepth:int = 5)
        {
            _fits = fits;
            _trees = trees;
            _library = library;
            _maxDepth = maxDepth;
        }

        /** Whether two agents collide. */
        public function areColliding(a:Agent, b:Agent):Boolean
        {
            if (a.hierarchical == b.hierarchical)
            {
                return a.hierarchical ? _trees.areColliding(a, b) : _fits.areColliding(a, b);
            }
            var tree:Agent = a.hierarchical ? a : b;
            return meets(_library.root(tree.shape), tree, a.hierarchical ? b : a, 1);
        }

        private function meets(node:HierarchyNode, agent:Agent, other:Agent, depth:int):Boolean
        {
            var bounds:BoundingStructure = LiteralTightestFitCollider.placed(node.bounds, agent);
            if (!LiteralTightestFitCollider.intersect(bounds, _fits.inWorld(other)))
            {
                return false;
            }
            return depth == _maxDepth || node.isLeaf || meets(node.left, agent, other, depth + 1) || meets(node.right, agent, other, depth + 1);
        }
    }
}
