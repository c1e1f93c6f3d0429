package starlogo.solid
{
    import starlogo.convex.RelativeMotion;
    import starlogo.engine;
    import starlogo.hierarchy.BoxTree;
    import starlogo.hierarchy.NodePairTest;
    import starlogo.hierarchy.NodePairBounds;
    import starlogo.hierarchy.RelativePose;
    import starlogo.hierarchy.TreeCounts;
    import starlogo.intersection.TriangleSeparation;

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
            _triangles.meshA.preparePlanes();
            return this;
        }

        /** @inheritDoc */
        override public function testNodes(treeA:BoxTree, a:int, treeB:BoxTree, b:int, bounds:NodePairBounds):Boolean
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

        // Whether a triangle of the second model touches a triangle in a range of the first.
        private function touchesSome(triangle:int, first:int, end:int):Boolean
        {
            var mesh:TriangleMesh = _triangles.meshA;
            var at:int = 6 * triangle;
            var extents:Vector.<Number> = _triangles.extents;
            var tolerance:Number = _triangles.outerTolerance;
            var minX:Number = extents[at] - tolerance;
            var minY:Number = extents[int(at + 2)] - tolerance;
            var minZ:Number = extents[int(at + 4)] - tolerance;
            var maxX:Number = extents[int(at + 1)] + tolerance;
            var maxY:Number = extents[int(at + 3)] + tolerance;
            var maxZ:Number = extents[int(at + 5)] + tolerance;
            extents = mesh.extents;
            _triangles.setSecond(triangle);
            for (var i:int = first; i < end; i++)
            {
                at = 6 * i;
                if (extents[at] > maxX || extents[int(at + 1)] < minX || extents[int(at + 2)] > maxY
                        || extents[int(at + 3)] < minY || extents[int(at + 4)] > maxZ || extents[int(at + 5)] < minZ)
                {
                    continue;
                }
                _triangles.counts.triangleTests++;
                if (_triangles.staysOnOneSide(i, triangle, RelativeMotion.NONE) || TriangleSeparation.areApart(mesh.corners, 9 * i, _triangles.b))
                {
                    continue;
                }
                _triangles.setFirst(i);
                if (_triangles.pair.areTouching(_triangles.a, _triangles.b))
                {
                    return true;
                }
            }
            return false;
        }
    }
}
