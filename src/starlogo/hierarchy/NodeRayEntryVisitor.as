package starlogo.hierarchy
{
    import starlogo.intersection.ray.Ray;
    import starlogo.intersection.ray.RayEntry;
    import starlogo.intersection.ray.RaySpan;
    import starlogo.intersection.ray.SpanFinder;

    /**
     * Finds where a ray first meets the boxes of a tree.
     *
     * <p>The ray meets a node no earlier than the node's ancestors. So a greater depth never finds a smaller distance.</p>
     *
     * @private
     */
    public final class NodeRayEntryVisitor extends NodeVisitor
    {
        /** The factor on a node's half-extents. Nodes are enlarged as it is. A node that is only touched would be entered before a larger node around it. */
        internal static const NOT_WIDENED:Number = 1;

        private var _ray:Ray = null;
        private var _span:RaySpan = new RaySpan();
        private var _entry:RayEntry = new RayEntry();
        private var _search:BoxSearch = new BoxSearch();

        // The node that the ray meets first, or -1.
        private var _first:int = -1;

        /**
         * Finds where a ray first enters a node that decides.
         *
         * @param tree the tree
         * @param depth how many of its levels are visited
         * @param ray in the tree's space
         * @param out receives the place and the normal
         * @return whether there is such a place
         */
        public function findRayEntry(tree:BoxTree, depth:int, ray:Ray, out:RayEntry):Boolean
        {
            _ray = ray;
            _first = -1;
            limit = ray.to;
            _search.visitAlong(ray, tree, depth, this);
            return _first >= 0 && enters(tree, _first, out);
        }

        /** @inheritDoc */
        override public function visit(tree:BoxTree, node:int):void
        {
            if (enters(tree, node, _entry) && (_entry.distance < limit || _first < 0))
            {
                _first = node;
                limit = _entry.distance;
                if (!(limit > _ray.from))
                {
                    // no node can be met before the ray's beginning
                    endSearch();
                }
            }
        }

        private function enters(tree:BoxTree, node:int, out:RayEntry):Boolean
        {
            return SpanFinder.findInBox(_ray, tree.boxOf(node), NOT_WIDENED, _span) && out.enter(_ray, _span);
        }
    }
}
