package starlogo.solid.interior
{
    import flash.geom.Vector3D;
    import starlogo.geometry.Tolerances;
    import starlogo.hierarchy.BoxSearch;
    import starlogo.hierarchy.BoxTree;
    import starlogo.hierarchy.NodeVisitor;

    /**
     * Whether a point has an open side: from there, a ray along an axis meets no node without children. Then no surface is around the point. This
     * needs nothing but the tree. It is asked before the inside of a model is known, because a level is mostly open to the sky.
     *
     * @private
     */
    public final class OpenSideVisitor extends NodeVisitor
    {
        private var _search:BoxSearch = new BoxSearch();

        // Whether the current ray has met a node.
        private var _isHit:Boolean = false;

        /** Whether a ray from the point along one of the six directions of the axes meets no node without children. */
        public function hasOpenSide(point:Vector3D, tree:BoxTree):Boolean
        {
            // Corners may move when seams are welded.
            var slack:Number = 8 * Tolerances.WELDING * (tree.radius + Math.abs(tree.boxes[0]) + Math.abs(tree.boxes[1]) + Math.abs(tree.boxes[2]));
            _search.setCube(point.x, point.y, point.z, slack);
            for (var i:int = 5; i >= 0; i--)
            {
                _search.setAxis(i >> 1, (i & 1) == 0 ? -1 : 1);
                _isHit = false;
                limit = Infinity;
                _search.visitMet(tree, BoxTree.EXACT, this);
                if (!_isHit)
                {
                    return true;
                }
            }
            return false;
        }

        /** @inheritDoc */
        override public function visit(tree:BoxTree, node:int):void
        {
            _isHit = true;
            endSearch();
        }
    }
}
