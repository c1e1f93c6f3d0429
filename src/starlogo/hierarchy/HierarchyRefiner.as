package starlogo.hierarchy
{
    import starlogo.engine;
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;

    use namespace engine;

    /**
     * Divides the leaves of a hierarchy of triangles further, down to a few triangles each, and packs all boxes, for tests of triangles and
     * rays. It works in steps. A hierarchy that was read with all its nodes is not divided again.
     *
     * @private
     */
    public final class HierarchyRefiner extends StepSequence
    {
        private static const ITEMS_PER_STEP:int = 1000;

        private var _hierarchy:Hierarchy;

        /**
         * @param hierarchy a finished hierarchy of triangles; receives the packed tree, and its triangles a new order
         */
        public function HierarchyRefiner(hierarchy:Hierarchy)
        {
            _hierarchy = hierarchy;
            if (hierarchy.items == null)
            {
                hierarchy.items = new TreeItems(hierarchy.vertices, hierarchy.triangles, hierarchy.order);
                slices(hierarchy.items.count, ITEMS_PER_STEP, hierarchy.items.measure);
            }
            begin(newDivider);
        }

        private function newDivider():Steps
        {
            var tree:PackedTree = new PackedTree(_hierarchy.root, _hierarchy.items);
            var divider:NodeDivider = new NodeDivider(_hierarchy.root, _hierarchy.items, tree.maker);
            divider.tree = _hierarchy.tree = tree;
            return divider;
        }
    }
}
