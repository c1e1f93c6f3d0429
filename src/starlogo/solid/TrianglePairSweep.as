package starlogo.solid
{
    import starlogo.convex.ContactPoint;
    import starlogo.convex.ConvexPair;
    import starlogo.convex.ConvexShape;
    import starlogo.convex.RelativeMotion;
    import starlogo.engine;
    import starlogo.hierarchy.BoxTree;
    import starlogo.hierarchy.LeafPairTest;
    import starlogo.hierarchy.RelativePose;
    import starlogo.hierarchy.TreeCounts;

    use namespace engine;

    /** Decides by triangles when two leaves first touch, for models that move. */
    internal final class TrianglePairSweep extends LeafPairTest
    {
        private var _triangles:MovedTriangles = new MovedTriangles();
        private var _pair:ConvexPair = new ConvexPair();
        private var _a:ConvexShape = new ConvexShape();
        private var _b:ConvexShape = new ConvexShape();
        private var _motion:RelativeMotion = new RelativeMotion();

        // How far off a plane corners have to be to be certainly on one side of it.
        private var _off:Number = 0;

        // The triangles that touch first: the indices of their corners, the second's in its own space. Then the second's corners in the
        // first model's space. This list begins empty, as the lists of MovedTriangles do, because V8 makes objects for Numbers that a method
        // writes to lists of both kinds.
        private var _firstA:int;
        private var _firstB:int;
        private var _corners:Vector.<Number> = new Vector.<Number>();

        private var _counts:TreeCounts;

        /** @param counts counts the pairs of triangles that are tested */
        public function TrianglePairSweep(counts:TreeCounts)
        {
            _counts = counts;
        }

        /** Begins with two models that have triangles. The pose must relate them already. Returns this. */
        public function begin(a:ModelTree, b:ModelTree, pose:RelativePose):LeafPairTest
        {
            _triangles.begin(a, b, pose);
            _motion.x = pose.motion.x;
            _motion.y = pose.motion.y;
            _motion.z = pose.motion.z;
            _off = _triangles.outerTolerance + _triangles.meshA.flatness;
            return this;
        }

        /** @inheritDoc */
        override public function testLeaves(treeA:BoxTree, a:int, treeB:BoxTree, b:int):Boolean
        {
            var count:int = _triangles.move(treeB, b);
            var first:int = treeA.first[a];
            var end:int = treeA.end[a];
            var tolerance:Number = _triangles.outerTolerance;
            var mesh:TriangleMesh = _triangles.meshA;
            var motion:RelativeMotion = _motion;
            var latest:Number = least;
            least = RelativeMotion.NEVER;
            var corners:Vector.<Number> = _triangles.moved;
            var spans:Vector.<Number> = _triangles.extents;
            var extents:Vector.<Number> = mesh.extents;
            // Higher indices come first, as in the traversal. So if several triangles touch at the same time, the result does not depend on
            // where leaves end.
            for (var k:int = count - 1; k >= 0; k--)
            {
                // the extents of the triangle during its motion until <code>latest</code>
                var span:int = 6 * k;
                var minX:Number = spans[span] - tolerance;
                var minY:Number = spans[int(span + 1)] - tolerance;
                var minZ:Number = spans[int(span + 2)] - tolerance;
                var maxX:Number = spans[int(span + 3)] + tolerance;
                var maxY:Number = spans[int(span + 4)] + tolerance;
                var maxZ:Number = spans[int(span + 5)] + tolerance;
                var displacement:Number = motion.x * latest;
                minX = displacement < 0 ? minX + displacement : minX;
                maxX = displacement > 0 ? maxX + displacement : maxX;
                displacement = motion.y * latest;
                minY = displacement < 0 ? minY + displacement : minY;
                maxY = displacement > 0 ? maxY + displacement : maxY;
                displacement = motion.z * latest;
                minZ = displacement < 0 ? minZ + displacement : minZ;
                maxZ = displacement > 0 ? maxZ + displacement : maxZ;
                _b.setTriangle(corners, 9 * k);
                _b.margin += _triangles.tolerance;
                for (var i:int = end - 1; i >= first; i--)
                {
                    var extent:int = 6 * i;
                    if (extents[extent] > maxX || extents[int(extent + 3)] < minX || extents[int(extent + 1)] > maxY
                            || extents[int(extent + 4)] < minY || extents[int(extent + 2)] > maxZ || extents[int(extent + 5)] < minZ)
                    {
                        continue;
                    }
                    _counts.triangleTests++;
                    motion.latest = latest;
                    if (staysOnOneSide(i, 9 * k))
                    {
                        continue;
                    }
                    _a.setTriangle(mesh.corners, 9 * i);
                    _pair.findTime(_b, _a, motion);
                    var impact:Number = motion.time;
                    if (impact < least)
                    {
                        least = latest = impact;
                        _firstA = 9 * i;
                        _firstB = 9 * (treeB.first[b] + k);
                        if (impact == 0)
                        {
                            return true;
                        }
                    }
                }
            }
            return least <= 1;
        }

        // Whether a triangle of the second model stays on one side of the plane of one of the first model's triangles until the
        // motion's latest time.
        private function staysOnOneSide(triangle:int, corner:int):Boolean
        {
            var mesh:TriangleMesh = _triangles.meshA;
            var planes:Vector.<Number> = mesh.planes;
            var corners:Vector.<Number> = _triangles.moved;
            var at:int = 4 * triangle;
            var x:Number = planes[at];
            var y:Number = planes[int(at + 1)];
            var z:Number = planes[int(at + 2)];
            var place:Number = planes[int(at + 3)];
            var p:Number = x * corners[corner] + y * corners[int(corner + 1)] + z * corners[int(corner + 2)] - place;
            var q:Number = x * corners[int(corner + 3)] + y * corners[int(corner + 4)] + z * corners[int(corner + 5)] - place;
            var r:Number = x * corners[int(corner + 6)] + y * corners[int(corner + 7)] + z * corners[int(corner + 8)] - place;
            var displacement:Number = _motion.latest * (x * _motion.x + y * _motion.y + z * _motion.z);
            var low:Number = displacement < 0 ? _off - displacement : _off;
            var high:Number = displacement > 0 ? -_off - displacement : -_off;
            return p > low && q > low && r > low || p < high && q < high && r < high;
        }

        /**
         * Finds the contact of the triangles that touch first, at the pose's time. It is in the first model's space.
         *
         * @param out receives the contact
         */
        public function findContact(out:ContactPoint):void
        {
            var pose:RelativePose = _triangles.pose;
            pose.placement.placePoints(_triangles.meshB.corners, _firstB, _firstB + 9, _corners);
            _a.setTriangle(_triangles.meshA.corners, _firstA);
            _b.setTriangle(_corners, 0);
            _motion.time = pose.motion.time;
            _pair.findContact(_b, _a, _motion, out);
            out.setNormal(-out.normalX, -out.normalY, -out.normalZ);
        }
    }
}
