package starlogo.solid
{
    import starlogo.convex.RelativeMotion;
    import starlogo.engine;
    import starlogo.hierarchy.BoxTree;
    import starlogo.hierarchy.NodePairTest;
    import starlogo.hierarchy.RelativePose;
    import starlogo.hierarchy.TreeCounts;

    use namespace engine;

    /** Decides by triangles whether two nodes touch, for models that stand still. */
    internal final class TrianglePairTest extends NodePairTest
    {
        private var _triangles:MovedTriangles;

        /** @param counts counts the pairs of triangles that are tested */
        public function TrianglePairTest(counts:TreeCounts)
        {
            _triangles = new MovedTriangles(counts);
        }

        /** Begins with two models that have triangles. The pose must relate them already. Returns this. */
        public function begin(a:ModelTree, b:ModelTree, pose:RelativePose):NodePairTest
        {
            _triangles.begin(a, b, pose, RelativeMotion.NONE);
            return this;
        }

        /** @inheritDoc */
        override public function areTouching(treeA:BoxTree, a:int, treeB:BoxTree, b:int):Boolean
        {
            var count:int = _triangles.move(treeB, b);
            for (var i:int = 0; i < count; i++)
            {
                if (touchesSome(i, treeA.first[a], treeA.end[a]))
                {
                    return true;
                }
            }
            return false;
        }

        // Whether a triangle of the second model's node touches one of the first model's triangles in a range of slots.
        private function touchesSome(index:int, first:int, end:int):Boolean
        {
            _triangles.setSecond(index, RelativeMotion.NONE);
            for (var i:int = first; i < end; i++)
            {
                if (_triangles.touches(i))
                {
                    return true;
                }
            }
            return false;
        }
    }
}
