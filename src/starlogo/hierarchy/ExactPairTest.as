package starlogo.hierarchy
{
    import starlogo.engine;
    import starlogo.geometry.Tolerances;
    import starlogo.intersection.triangleTriangle;

    use namespace engine;

    /**
     * Decides by the models' triangles where their hierarchies leave it open: whether those of two leaves touch.
     */
    internal final class ExactPairTest
    {
        /** Pairs of triangles that were tested; HierarchyTraversal sets it to 0. */
        public var triangleTests:int = 0;

        private var _pose:RelativePose;

        private var _solidA:Solid;
        private var _solidB:Solid;

        // How close triangles of these models touch.
        private var _touching:Number;

        // The triangles of a leaf of the second model in the space of the first.
        private var _corners:Vector.<Number> = new Vector.<Number>();
        private var _cornersOf:HierarchyNode;

        /**
         * @param pose where the second model is in the space of the first, whenever two are asked about
         */
        public function ExactPairTest(pose:RelativePose)
        {
            _pose = pose;
        }

        /**
         * Prepares for two models that the pose relates.
         *
         * @return whether both have triangles; otherwise nothing else may be asked
         */
        public function prepare(a:Hierarchy, b:Hierarchy):Boolean
        {
            if (!a.hasTriangles || !b.hasTriangles)
            {
                return false;
            }
            _solidA = a.solid;
            _solidB = b.solid;
            _cornersOf = null;
            _touching = Tolerances.SURFACES * (a.root.radius + b.root.radius * _pose.placement.size);
            return true;
        }

        /** Whether a triangle of a leaf of the first model touches one of a leaf of the second. */
        public function leavesTouch(a:HierarchyNode, b:HierarchyNode):Boolean
        {
            if (b !== _cornersOf)
            {
                _pose.movePoints(_solidB.corners, 9 * b.first, 9 * b.end, _corners);
                _cornersOf = b;
            }
            var cornersA:Vector.<Number> = _solidA.corners;
            var extents:Vector.<Number> = _solidA.extents;
            var corners:Vector.<Number> = _corners;
            var touching:Number = _touching;
            var lowX:Number = a.x - a.halfX;
            var lowY:Number = a.y - a.halfY;
            var lowZ:Number = a.z - a.halfZ;
            var highX:Number = a.x + a.halfX;
            var highY:Number = a.y + a.halfY;
            var highZ:Number = a.z + a.halfZ;
            var first:int = a.first;
            var last:int = a.end;
            var length:int = 9 * (b.end - b.first);

            // each triangle of b that reaches into a's box, with those of a whose extents it overlaps
            for (var at:int = 0; at < length; at += 9)
            {
                var p:Number = corners[at];
                var q:Number = corners[int(at + 3)];
                var r:Number = corners[int(at + 6)];
                var minX:Number = p < q ? p : q;
                minX = minX < r ? minX : r;
                minX -= touching;
                var maxX:Number = p > q ? p : q;
                maxX = maxX > r ? maxX : r;
                maxX += touching;
                if (minX > highX || maxX < lowX)
                {
                    continue;
                }
                p = corners[int(at + 1)];
                q = corners[int(at + 4)];
                r = corners[int(at + 7)];
                var minY:Number = p < q ? p : q;
                minY = minY < r ? minY : r;
                minY -= touching;
                var maxY:Number = p > q ? p : q;
                maxY = maxY > r ? maxY : r;
                maxY += touching;
                if (minY > highY || maxY < lowY)
                {
                    continue;
                }
                p = corners[int(at + 2)];
                q = corners[int(at + 5)];
                r = corners[int(at + 8)];
                var minZ:Number = p < q ? p : q;
                minZ = minZ < r ? minZ : r;
                minZ -= touching;
                var maxZ:Number = p > q ? p : q;
                maxZ = maxZ > r ? maxZ : r;
                maxZ += touching;
                if (minZ > highZ || maxZ < lowZ)
                {
                    continue;
                }
                for (var i:int = first; i < last; i++)
                {
                    var extent:int = 6 * i;
                    if (extents[extent] > maxX || extents[int(extent + 3)] < minX || extents[int(extent + 1)] > maxY
                            || extents[int(extent + 4)] < minY || extents[int(extent + 2)] > maxZ || extents[int(extent + 5)] < minZ)
                    {
                        continue;
                    }
                    triangleTests++;
                    if (triangleTriangle(cornersA, 9 * i, corners, at, touching))
                    {
                        return true;
                    }
                }
            }
            return false;
        }
    }
}
