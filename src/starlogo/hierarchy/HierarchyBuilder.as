package starlogo.hierarchy
{
    import starlogo.engine;
    import starlogo.steps.StepSequence;

    use namespace engine;

    /**
     * Builds a hierarchy from the root down (thesis §4.4).
     *
     * <p>It divides items: triangles, or vertices if there are no triangles. NodeDivider says how.</p>
     *
     * <p>It works in steps, each of one or two milliseconds for thousands of items. The steps throw an ArgumentError if a coordinate is
     * larger than 1e60.</p>
     *
     * @private
     */
    public final class HierarchyBuilder extends StepSequence
    {
        private static const ITEMS_PER_STEP:int = 1000;

        private var _hierarchy:Hierarchy;
        private var _maxDepth:int;
        private var _divider:NodeDivider;
        private var _items:TreeItems;
        private var _tree:StoredTree = null;

        /**
         * @param hierarchy receives the nodes, and the order of its items
         * @param minVerticesToSplit a node with at most this many vertices is a leaf
         * @param maxDepth a node on this level is a leaf
         * @param splitByMean whether to split at the mean
         */
        public function HierarchyBuilder(hierarchy:Hierarchy, minVerticesToSplit:int, maxDepth:int, splitByMean:Boolean)
        {
            _hierarchy = hierarchy;
            _maxDepth = maxDepth;
            _divider = new NodeDivider(minVerticesToSplit, maxDepth, splitByMean);
            call(beginItems);
        }

        /**
         * Makes a stored tree's nodes again if that tree divides these items. Otherwise the items are divided as usual. Must be called
         * before the first step.
         */
        public function useStored(tree:StoredTree):void
        {
            _tree = tree;
        }

        /** Whether the nodes come from a stored tree. */
        public function get isStored():Boolean
        {
            return _tree != null;
        }

        private function beginItems():void
        {
            _items = new TreeItems(_hierarchy.vertices, _hierarchy.triangles);
            _hierarchy.order = _items.order;
            if (_tree == null)
            {
                addDivision();
                return;
            }
            _tree.start(_hierarchy, _hierarchy.vertices, _hierarchy.triangles, _maxDepth);
            add(_tree).call(useNodes);
        }

        private function useNodes():void
        {
            if (_tree.nodes == null)
            {
                _tree = null;
                addDivision();
            }
        }

        private function addDivision():void
        {
            slices(_items.count, ITEMS_PER_STEP, _items.measure).call(makeRoot).add(_divider);
        }

        private function makeRoot():void
        {
            var maker:NodeMaker = new NodeMaker(_hierarchy, _items.bounds);
            _hierarchy.root = maker.make(1, 0, _items.count, _items.bounds);
            _hierarchy.items = _hierarchy.hasTriangles ? _items : null;
            _divider.begin(_hierarchy.root, _items, maker);
        }
    }
}
