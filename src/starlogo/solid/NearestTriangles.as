package starlogo.solid
{
    import starlogo.engine;
    import starlogo.hierarchy.HierarchyNode;
    import starlogo.hierarchy.LeafDistance;
    import starlogo.hierarchy.RelativePose;
    import starlogo.intersection.ClosestTriangles;

    use namespace engine;

    /**
     * Finds how far the triangles in leaves are apart. Only those pairs are measured whose extents are nearer than the nearest pair so far.
     */
    internal final class NearestTriangles extends LeafDistance
    {
        /** Pairs of triangles that were measured; set to 0 from outside. */
        public var triangleTests:int = 0;

        /** Has the points of the nearest pair, in the space of the first model. */
        public var nearest:ClosestTriangles = new ClosestTriangles();

        private var _pose:RelativePose;
        private var _solidA:Solid;
        private var _solidB:Solid;

        // The triangles of a leaf of the second model in the space of the first.
        private var _corners:Vector.<Number> = new Vector.<Number>();
        private var _cornersOf:HierarchyNode;

        // From the first model's point to the second's of the nearest pair; up to where along that a triangle of the first is not nearer.
        private var _alongX:Number;
        private var _alongY:Number;
        private var _alongZ:Number;
        private var _begin:Number;

        /**
         * @param pose where the second model is in the space of the first, whenever two are asked about
         */
        public function NearestTriangles(pose:RelativePose)
        {
            _pose = pose;
        }

        /** Begins anew, with two models that the pose relates. */
        public function begin(a:Solid, b:Solid):void
        {
            _solidA = a;
            _solidB = b;
            _cornersOf = null;
            least = Infinity;
            nearest.begin();
        }

        /** @inheritDoc */
        override public function add(a:HierarchyNode, b:HierarchyNode):void
        {
            if (b !== _cornersOf)
            {
                _pose.movePoints(_solidB.corners, 9 * b.first, 9 * b.end, _corners);
                _cornersOf = b;
            }
            var corners:Vector.<Number> = _corners;
            var length:int = 9 * (b.end - b.first);
            for (var at:int = 0; at < length && nearest.squared > 0; at += 9)
            {
                addTriangle(a, corners, at);
            }
            least = Math.sqrt(nearest.squared);
            x = nearest.points.bX - nearest.points.aX;
            y = nearest.points.bY - nearest.points.aY;
            z = nearest.points.bZ - nearest.points.aZ;
        }

        // A triangle of the second model with each of a leaf of the first.
        private function addTriangle(a:HierarchyNode, corners:Vector.<Number>, at:int):void
        {
            var p:Number = corners[at];
            var q:Number = corners[int(at + 3)];
            var r:Number = corners[int(at + 6)];
            var low:Number = p < q ? p : q;
            var minX:Number = low < r ? low : r;
            var high:Number = p > q ? p : q;
            var maxX:Number = high > r ? high : r;
            p = corners[int(at + 1)];
            q = corners[int(at + 4)];
            r = corners[int(at + 7)];
            low = p < q ? p : q;
            var minY:Number = low < r ? low : r;
            high = p > q ? p : q;
            var maxY:Number = high > r ? high : r;
            p = corners[int(at + 2)];
            q = corners[int(at + 5)];
            r = corners[int(at + 8)];
            low = p < q ? p : q;
            var minZ:Number = low < r ? low : r;
            high = p > q ? p : q;
            var maxZ:Number = high > r ? high : r;

            // the leaf's box is wider than what is in it
            var squared:Number = 0;
            var gap:Number = minX > a.x ? minX - a.x - a.halfX : a.x - a.halfX - maxX;
            if (gap > 0)
            {
                squared = gap * gap;
            }
            gap = minY > a.y ? minY - a.y - a.halfY : a.y - a.halfY - maxY;
            if (gap > 0)
            {
                squared += gap * gap;
            }
            gap = minZ > a.z ? minZ - a.z - a.halfZ : a.z - a.halfZ - maxZ;
            if (gap > 0)
            {
                squared += gap * gap;
            }
            var limit:Number = nearest.squared;
            if (squared >= limit)
            {
                return;
            }
            turnTo(corners, at);
            var extents:Vector.<Number> = _solidA.extents;
            var end:int = a.end;
            for (var i:int = a.first; i < end; i++)
            {
                var extent:int = 6 * i;
                squared = 0;
                gap = extents[extent] - maxX;
                if (gap < 0)
                {
                    gap = minX - extents[int(extent + 3)];
                }
                if (gap > 0)
                {
                    squared = gap * gap;
                }
                gap = extents[int(extent + 1)] - maxY;
                if (gap < 0)
                {
                    gap = minY - extents[int(extent + 4)];
                }
                if (gap > 0)
                {
                    squared += gap * gap;
                }
                gap = extents[int(extent + 2)] - maxZ;
                if (gap < 0)
                {
                    gap = minZ - extents[int(extent + 5)];
                }
                if (gap > 0)
                {
                    squared += gap * gap;
                }
                if (squared < limit && !isBeyond(_solidA.corners, 9 * i))
                {
                    triangleTests++;
                    nearest.add(_solidA.corners, 9 * i, corners, at);
                    if (nearest.squared < limit)
                    {
                        limit = nearest.squared;
                        turnTo(corners, at);
                    }
                }
            }
        }

        // Measures a triangle of the second model along the line between the nearest points so far.
        private function turnTo(corners:Vector.<Number>, at:int):void
        {
            var alongX:Number = nearest.points.bX - nearest.points.aX;
            var alongY:Number = nearest.points.bY - nearest.points.aY;
            var alongZ:Number = nearest.points.bZ - nearest.points.aZ;
            var p:Number = alongX * corners[at] + alongY * corners[int(at + 1)] + alongZ * corners[int(at + 2)];
            var q:Number = alongX * corners[int(at + 3)] + alongY * corners[int(at + 4)] + alongZ * corners[int(at + 5)];
            var r:Number = alongX * corners[int(at + 6)] + alongY * corners[int(at + 7)] + alongZ * corners[int(at + 8)];
            p = p < q ? p : q;
            p = p < r ? p : r;
            // the nearest pair is as far apart along it as it is long
            _begin = p - nearest.squared;
            _alongX = alongX;
            _alongY = alongY;
            _alongZ = alongZ;
        }

        // Whether a triangle of the first model is not nearer to that one along the line than the nearest pair is.
        private function isBeyond(corners:Vector.<Number>, at:int):Boolean
        {
            var alongX:Number = _alongX;
            var alongY:Number = _alongY;
            var alongZ:Number = _alongZ;
            var begin:Number = _begin;
            return alongX * corners[at] + alongY * corners[int(at + 1)] + alongZ * corners[int(at + 2)] <= begin
                && alongX * corners[int(at + 3)] + alongY * corners[int(at + 4)] + alongZ * corners[int(at + 5)] <= begin
                && alongX * corners[int(at + 6)] + alongY * corners[int(at + 7)] + alongZ * corners[int(at + 8)] <= begin;
        }
    }
}
