package starlogo.hierarchy
{
    import starlogo.engine;
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;

    use namespace engine;

    /**
     * Divides the leaves of a hierarchy of triangles further, down to a few triangles each, for tests of triangles and rays. It works in
     * steps. A hierarchy that was read with all its nodes stays as it is.
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
            if (hasLargeLeaf())
            {
                _items = new TreeItems(hierarchy.vertices, hierarchy.triangles, hierarchy.order);
                slices(_items.count, ITEMS_PER_STEP, _items.measure).begin(newDivider);
            }
        }

        private function hasLargeLeaf():Boolean
        {
            var stack:Vector.<HierarchyNode> = new <HierarchyNode>[_hierarchy.root];
            while (stack.length > 0)
            {
                var node:HierarchyNode = stack.pop();
                if (node.low != null)
                {
                    stack.push(node.low, node.high);
                }
                else if (node.end - node.first > LEAF_SIZE)
                {
                    return true;
                }
            }
            return false;
        }

        private function newDivider():Steps
        {
            var divider:NodeDivider = new NodeDivider(_hierarchy.root, _items, new NodeMaker(_hierarchy, _items.extents));
            divider.leafSize = LEAF_SIZE;
            return divider;
        }
    }
}
