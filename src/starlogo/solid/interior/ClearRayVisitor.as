package starlogo.solid.interior
{
    import flash.geom.Vector3D;
    import starlogo.geometry.Tolerances;
    import starlogo.hierarchy.BoxSearch;
    import starlogo.hierarchy.BoxTree;
    import starlogo.hierarchy.NodeVisitor;

    /**
     * Whether a ray from a point along an axis is clear: it meets no node without children. Then no surface is around the point. This
     * needs nothing but the tree. It is asked before the inside of a model is known, because a level is mostly open to the sky.
     *
     * @private
     */
    public final class ClearRayVisitor extends NodeVisitor
    {
        private var _search:BoxSearch = new BoxSearch();

        /** Whether a ray from the point along one of the six directions of the axes meets no node without children. */
        public function hasClearRay(point:Vector3D, tree:BoxTree):Boolean
        {
            // Corners may move when seams are welded.
            var slack:Number = 8 * Tolerances.WELDING * (tree.boundingRadius + Math.abs(tree.boxes[0]) + Math.abs(tree.boxes[1]) + Math.abs(tree.boxes[2]));
            _search.setCube(point.x, point.y, point.z, slack);
            for (var i:int = 5; i >= 0; i--)
            {
                _search.setAxis(i >> 1, (i & 1) == 0 ? -1 : 1);
                limit = Infinity;
                _search.visitMet(tree, BoxTree.EXACT, this);
                // a node that is met ends the search
                if (limit == Infinity)
                {
                    return true;
                }
            }
            return false;
        }

        /** @inheritDoc */
        override public function visit(tree:BoxTree, node:int):void
        {
            endSearch();
        }
    }
}
