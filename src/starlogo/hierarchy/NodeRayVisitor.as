package starlogo.hierarchy
{
    import starlogo.bounding.Box;
    import starlogo.intersection.ray.Ray;
    import starlogo.intersection.ray.RayCrossings;
    import starlogo.intersection.ray.RayEntry;
    import starlogo.intersection.ray.rayBox;

    /**
     * Finds where a ray first meets the boxes of a tree, or all places where it does.
     *
     * <p>The ray meets a node no earlier than the node's ancestors. So a greater depth never finds a smaller distance.</p>
     *
     * @private
     */
    public final class NodeRayVisitor extends NodeVisitor
    {
        private var _ray:Ray = new Ray();
        private var _entry:RayEntry = new RayEntry();
        private var _all:RayCrossings = null;
        private var _slack:Number = 0;
        private var _search:BoxSearch = new BoxSearch();
        private var _box:Box = BoxTree.newBox();

        // The node that the ray meets first, or -1.
        private var _first:int = -1;

        public function NodeRayVisitor()
        {
            // Nodes are enlarged as it is. A node that is only touched would be entered before a larger node around it.
            _ray.touchingFactor = 1;
        }

        /**
         * Finds where a ray first enters a node that decides.
         *
         * @param tree the tree
         * @param depth how many of its levels are visited
         * @param ray in the tree's space
         * @param out receives the place and the normal
         * @return whether there is such a place
         */
        public function findHit(tree:BoxTree, depth:int, ray:Ray, out:RayEntry):Boolean
        {
            findAll(tree, depth, ray, 0, null);
            return _first >= 0 && rayBox(_ray, tree.writeBox(_first, _box), out);
        }

        /**
         * Adds where a ray enters and leaves each node that decides.
         *
         * @param tree the tree
         * @param depth how many of its levels are visited
         * @param ray in the tree's space
         * @param slack how far a place may be wrong because of rounding
         * @param out the crossings are added to it. Null if only the first node is wanted
         */
        public function findAll(tree:BoxTree, depth:int, ray:Ray, slack:Number, out:RayCrossings):void
        {
            _ray.copyFrom(ray);
            _slack = slack;
            _all = out;
            _first = -1;
            limit = ray.to;
            _search.setRay(ray);
            _search.find(tree, depth, this);
        }

        /** @inheritDoc */
        override public function visit(tree:BoxTree, node:int):void
        {
            tree.writeBox(node, _box);
            if (_all != null)
            {
                _all.addStructure(_ray, _box, null, _slack);
                return;
            }
            if (rayBox(_ray, _box, _entry) && (_entry.distance < limit || _first < 0))
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
    }
}
