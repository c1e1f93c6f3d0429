package evaluation.literal
{
    import starlogo.agents.Agent;
    import starlogo.bounding.Box;
    import starlogo.hierarchy.HierarchyNode;
    import starlogo.libraries.HierarchiesLibrary;

    /**
     * The HierarchicalCollider as the thesis describes it (§4.5, §4.6). For each visited pair of nodes, both boxes are copied, scaled,
     * rotated and translated. Then their eight corners are tested on fifteen axes. If the boxes intersect, each child of one is visited
     * with each child of the other.
     */
    public final class LiteralHierarchicalCollider
    {
        private var _library:HierarchiesLibrary;
        private var _maxDepth:int;
        private var _agentA:Agent;
        private var _agentB:Agent;

        /**
         * @param library has the hierarchies
         * @param maxDepth the number of levels to visit
         */
        public function LiteralHierarchicalCollider(library:HierarchiesLibrary, maxDepth:int = 5)
        {
            _library = library;
            _maxDepth = maxDepth;
        }

        /** Whether two agents collide. */
        public function areColliding(a:Agent, b:Agent):Boolean
        {
            _agentA = a;
            _agentB = b;
            return nodesMeet(_library.root(a.shape), _library.root(b.shape), 1);
        }

        private function nodesMeet(a:HierarchyNode, b:HierarchyNode, depth:int):Boolean
        {
            if (!boxBox(LiteralTightestFitCollider.placed(a.bounds, _agentA) as Box, LiteralTightestFitCollider.placed(b.bounds, _agentB) as Box))
            {
                return false;
            }
            if (depth == _maxDepth || (a.isLeaf && b.isLeaf))
            {
                return true;
            }
            if (a.isLeaf)
            {
                return nodesMeet(a, b.left, depth + 1) || nodesMeet(a, b.right, depth + 1);
            }
            if (b.isLeaf)
            {
                return nodesMeet(a.left, b, depth + 1) || nodesMeet(a.right, b, depth + 1);
            }
            return nodesMeet(a.left, b.left, depth + 1) || nodesMeet(a.left, b.right, depth + 1)
                || nodesMeet(a.right, b.left, depth + 1) || nodesMeet(a.right, b.right, depth + 1);
        }
    }
}
