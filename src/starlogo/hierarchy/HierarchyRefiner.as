package starlogo.hierarchy
{
    import starlogo.engine;
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;

    use namespace engine;

    /**
     * Divides the leaves of a hierarchy of triangles further, down to a few triangles each, for tests of triangles and rays. It works in
     * steps. A hierarchy that was read with all its nodes keeps them.
     *
     * @private
     */
    public final class HierarchyRefiner extends StepSequence
    {
        private static const LEAF_SIZE:int = 8;
        private static const ITEMS_PER_STEP:int = 1000;

        private var _hierarchy:Hierarchy;
        private var _items:TreeItems;

        /**
         * @param hierarchy a finished hierarchy of triangles; its leaves receive children, and the triangles a new order
         */
        public function HierarchyRefiner(hierarchy:Hierarchy)
        {
            _hierarchy = hierarchy;
            _items = hierarchy.items;
            hierarchy.items = null;
            if (_items == null)
            {
                _items = new TreeItems(hierarchy.vertices, hierarchy.triangles, hierarchy.order);
                slices(_items.count, ITEMS_PER_STEP, _items.measure);
            }
            begin(newDivider);
        }

        /** When no step is left: the triangles' extents in the hierarchy's order, minX, minY, minZ, maxX, maxY, maxZ of each. */
        public function get extents():Vector.<Number>
        {
            return _items.extents;
        }

        private function newDivider():Steps
        {
            var divider:NodeDivider = new NodeDivider(_hierarchy.root, _items, new NodeMaker(_hierarchy, _items.bounds));
            divider.leafSize = LEAF_SIZE;
            return divider;
        }
    }
}
