package starlogo.hierarchy
{
    import starlogo.geometry.Tolerances;
    import starlogo.intersection.ray.Ray;
    import starlogo.intersection.ray.RayCrossings;
    import starlogo.intersection.ray.RaySpan;
    import starlogo.intersection.ray.SpanFinder;

    /** Finds all places where a ray meets the boxes of a tree. @private */
    public final class NodeRayCrossingVisitor extends NodeVisitor
    {
        private var _ray:Ray = null;
        private var _span:RaySpan = new RaySpan();
        private var _all:RayCrossings = null;
        private var _search:BoxSearch = new BoxSearch();

        /**
         * Adds where a ray enters and leaves each node that decides.
         *
         * @param tree the tree
         * @param depth how many of its levels are visited
         * @param ray in the tree's space
         * @param out the crossings are added to it
         */
        public function addCrossings(tree:BoxTree, depth:int, ray:Ray, out:RayCrossings):void
        {
            _ray = ray;
            _all = out;
            limit = ray.to;
            _search.visitAlong(ray, tree, depth, this);
        }

        /** @inheritDoc */
        override public function visit(tree:BoxTree, node:int):void
        {
            if (SpanFinder.findInBox(_ray, tree.boxOf(node), NodeRayEntryVisitor.NOT_WIDENED, _span))
            {
                _all.addSpan(_ray, _span, Tolerances.ROUNDING * tree.radiusAboutOrigin);
            }
        }
    }
}
