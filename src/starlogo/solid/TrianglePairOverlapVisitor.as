package starlogo.solid
{
    import starlogo.convex.RelativeMotion;
    import starlogo.engine;
    import starlogo.hierarchy.BoxTree;
    import starlogo.hierarchy.OverlapVisitor;
    import starlogo.hierarchy.RelativePose;
    import starlogo.hierarchy.TreeCounts;

    use namespace engine;

    /** Decides by triangles whether two nodes touch, for models that stand still. */
    internal final class TrianglePairOverlapVisitor extends OverlapVisitor
    {
        private var _triangles:MovedTriangles;

        /** @param counts counts the pairs of triangles that are tested */
        public function TrianglePairOverlapVisitor(counts:TreeCounts)
        {
            _triangles = new MovedTriangles(counts);
        }

        /** Begins with two models that have triangles. The pose must relate them already. Returns this. */
        public function begin(a:ModelTree, b:ModelTree, pose:RelativePose):OverlapVisitor
        {
            _triangles.begin(a, b, pose, RelativeMotion.NONE);
            return this;
        }

        /** @inheritDoc */
        override public function areTouching(treeA:BoxTree, a:int, treeB:BoxTree, b:int):Boolean
        {
            var count:int = _triangles.move(treeB, b);
            var end:int = treeA.end[a];
            for (var i:int = 0; i < count; i++)
            {
                _triangles.setSecond(i, RelativeMotion.NONE);
                for (var slot:int = treeA.first[a]; slot < end; slot++)
                {
                    if (_triangles.touches(slot))
                    {
                        return true;
                    }
                }
            }
            return false;
        }
    }
}
