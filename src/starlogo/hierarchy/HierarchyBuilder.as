package starlogo.hierarchy
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.engine;
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;

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
        // The approximate work of a step, in items. Making a node counts as ITEMS_PER_NODE items.
        private static const ITEMS_PER_STEP:int = 1000;
        private static const ITEMS_PER_NODE:int = 10;

        private var _hierarchy:Hierarchy;
        private var _minVerticesToSplit:int;
        private var _maxDepth:int;
        private var _splitByMean:Boolean;
        private var _items:Items;
        private var _tree:StoredTree = null;
        private var _maker:NodeMaker;
        private var _divider:NodeDivider;
        private var _nodes:Vector.<HierarchyNode>;
        private var _structures:NodeStructures;
        private var _next:int = 0;

        /**
         * @param hierarchy receives the nodes, and the order of its items
         * @param minVerticesToSplit a node with at most this many vertices is a leaf
         * @param maxDepth a node on this level is a leaf
         * @param splitByMean whether to split at the mean
         */
        public function HierarchyBuilder(hierarchy:Hierarchy, minVerticesToSplit:int, maxDepth:int, splitByMean:Boolean)
        {
            _hierarchy = hierarchy;
            _minVerticesToSplit = minVerticesToSplit;
            _maxDepth = maxDepth;
            _splitByMean = splitByMean;
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
            _items = new Items(_hierarchy.vertices, _hierarchy.triangles);
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
            _nodes = _tree.nodes;
            _maker = _tree.maker;
            if (_nodes == null)
            {
                _tree = null;
                addDivision();
                return;
            }
            addStructures();
        }

        private function addDivision():void
        {
            slices(_items.count, ITEMS_PER_STEP, _items.measure).call(makeRoot).begin(newDivider).call(useDivided);
        }

        private function makeRoot():void
        {
            var extents:Vector.<Number> = _items.extents;
            _maker = new NodeMaker(_hierarchy, extents);
            _hierarchy.root = _maker.make(1, 0, _items.count, extents);
        }

        private function newDivider():Steps
        {
            _divider = new NodeDivider(_hierarchy.root, _items, _maker);
            _divider.minVerticesToSplit = _minVerticesToSplit;
            _divider.maxDepth = _maxDepth;
            _divider.splitByMean = _splitByMean;
            return _divider;
        }

        private function useDivided():void
        {
            _nodes = _divider.nodes;
            addStructures();
        }

        private function addStructures():void
        {
            if (_hierarchy.boundsKind != BoundingStructure.BOX)
            {
                _structures = new NodeStructures(_hierarchy.boundsKind, _items, 2 * _maker.marginOf(1));
                repeat(encloseSome).repeat(coverSome);
            }
        }

        private function encloseSome():Boolean
        {
            var items:int = 0;
            while (_next < _nodes.length && items < ITEMS_PER_STEP)
            {
                var node:HierarchyNode = _nodes[_next++];
                _structures.enclose(node);
                items += node.end - node.first + ITEMS_PER_NODE;
            }
            return _next < _nodes.length;
        }

        // Goes from the last node to the first, because children come after their parents.
        private function coverSome():Boolean
        {
            var last:int = Math.max(0, _next - ITEMS_PER_STEP / ITEMS_PER_NODE);
            while (_next > last)
            {
                var node:HierarchyNode = _nodes[--_next];
                if (!node.isLeaf)
                {
                    _structures.cover(node);
                }
            }
            return _next > 0;
        }
    }
}
