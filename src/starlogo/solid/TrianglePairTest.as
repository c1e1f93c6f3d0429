package starlogo.solid
{
    import starlogo.convex.ConvexPair;
    import starlogo.convex.ConvexShape;
    import starlogo.engine;
    import starlogo.hierarchy.BoxTree;
    import starlogo.hierarchy.LeafPairTest;
    import starlogo.hierarchy.RelativePose;
    import starlogo.hierarchy.TreeCounts;
    import starlogo.intersection.TriangleSeparation;

    use namespace engine;

    /** Decides by triangles whether two leaves touch, for models that stand still. */
    internal final class TrianglePairTest extends LeafPairTest
    {
        private var _triangles:MovedTriangles = new MovedTriangles();
        private var _pair:ConvexPair = new ConvexPair();
        private var _a:ConvexShape = new ConvexShape();
        private var _b:ConvexShape = new ConvexShape();

        private var _counts:TreeCounts;

        /** @param counts counts the pairs of triangles that are tested */
        public function TrianglePairTest(counts:TreeCounts)
        {
            _counts = counts;
        }

        /** Begins with two models that have triangles. The pose must relate them already. Returns this. */
        public function begin(a:ModelTree, b:ModelTree, pose:RelativePose):LeafPairTest
        {
            _triangles.begin(a, b, pose);
            return this;
        }

        /** @inheritDoc */
        override public function testLeaves(treeA:BoxTree, a:int, treeB:BoxTree, b:int):Boolean
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
            var minY:Number = extents[int(at + 1)] - tolerance;
            var minZ:Number = extents[int(at + 2)] - tolerance;
            var maxX:Number = extents[int(at + 3)] + tolerance;
            var maxY:Number = extents[int(at + 4)] + tolerance;
            var maxZ:Number = extents[int(at + 5)] + tolerance;
            var corners:Vector.<Number> = _triangles.moved;
            var corner:int = 9 * triangle;
            var px:Number = corners[corner];
            var py:Number = corners[int(corner + 1)];
            var pz:Number = corners[int(corner + 2)];
            var qx:Number = corners[int(corner + 3)];
            var qy:Number = corners[int(corner + 4)];
            var qz:Number = corners[int(corner + 5)];
            var rx:Number = corners[int(corner + 6)];
            var ry:Number = corners[int(corner + 7)];
            var rz:Number = corners[int(corner + 8)];
            extents = mesh.extents;
            var planes:Vector.<Number> = mesh.planes;
            var off:Number = tolerance + mesh.flatness;
            _b.setTriangle(corners, corner);
            _b.margin += _triangles.tolerance;
            for (var i:int = first; i < end; i++)
            {
                at = 6 * i;
                if (extents[at] > maxX || extents[int(at + 3)] < minX || extents[int(at + 1)] > maxY
                        || extents[int(at + 4)] < minY || extents[int(at + 2)] > maxZ || extents[int(at + 5)] < minZ)
                {
                    continue;
                }
                _counts.triangleTests++;

                // Most triangles are on one side of the other's plane.
                at = 4 * i;
                var nx:Number = planes[at];
                var ny:Number = planes[int(at + 1)];
                var nz:Number = planes[int(at + 2)];
                var place:Number = planes[int(at + 3)];
                var p:Number = nx * px + ny * py + nz * pz - place;
                var q:Number = nx * qx + ny * qy + nz * qz - place;
                var r:Number = nx * rx + ny * ry + nz * rz - place;
                if (p > off && q > off && r > off || p < -off && q < -off && r < -off)
                {
                    continue;
                }
                if (TriangleSeparation.areApart(mesh.corners, 9 * i, _b))
                {
                    continue;
                }
                _a.setTriangle(mesh.corners, 9 * i);
                if (_pair.areTouching(_a, _b))
                {
                    return true;
                }
            }
            return false;
        }
    }
}
