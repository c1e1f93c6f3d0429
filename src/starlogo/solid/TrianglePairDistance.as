package starlogo.solid
{
    import starlogo.convex.ClosestPoints;
    import starlogo.convex.RelativeMotion;
    import starlogo.engine;
    import starlogo.hierarchy.BoxTree;
    import starlogo.hierarchy.NodePairTest;
    import starlogo.hierarchy.NodePairBounds;
    import starlogo.hierarchy.RelativePose;
    import starlogo.hierarchy.TreeCounts;

    use namespace engine;

    /** Finds the distance of the triangles of two nodes. It measures only pairs whose extents are nearer than the nearest pair so far. */
    internal final class TrianglePairDistance extends NodePairTest
    {
        private var _triangles:MovedTriangles;

        // The closest points of the nearest pair so far, and their squared distance.
        private var _points:ClosestPoints;
        private var _squared:Number = 0;

        // The vector from the first model's point to the second's in the nearest pair, and the place along it beyond which a triangle of
        // the first model may be nearer.
        private var _alongX:Number;
        private var _alongY:Number;
        private var _alongZ:Number;
        private var _begin:Number;

        /** @param counts counts the pairs of triangles that are measured */
        public function TrianglePairDistance(counts:TreeCounts)
        {
            _triangles = new MovedTriangles(counts);
        }

        /**
         * Begins with two models that have triangles. The pose must relate them already. Returns this.
         *
         * @param points receives the closest points, and their distance; kept
         */
        public function begin(a:ModelTree, b:ModelTree, pose:RelativePose, points:ClosestPoints):NodePairTest
        {
            _triangles.begin(a, b, pose, RelativeMotion.NONE);
            _points = points;
            _squared = Infinity;
            return this;
        }

        /** @inheritDoc */
        override public function testNodes(treeA:BoxTree, a:int, treeB:BoxTree, b:int, bounds:NodePairBounds):Boolean
        {
            var count:int = _triangles.move(treeB, b);
            for (var i:int = 0; i < count && _points.distance > 0; i++)
            {
                addTriangle(treeA.first[a], treeA.end[a], i);
            }
            bounds.current = _points.distance;
            return bounds.current < bounds.least;
        }

        // Adds each triangle of a range of the first model, paired with a triangle of the second.
        private function addTriangle(first:int, end:int, triangle:int):void
        {
            var mesh:TriangleMesh = _triangles.meshA;
            var corners:Vector.<Number> = _triangles.moved;
            var at:int = 9 * triangle;
            var extents:Vector.<Number> = _triangles.extents;
            var extent:int = 6 * triangle;
            var minX:Number = extents[extent];
            var minY:Number = extents[int(extent + 2)];
            var minZ:Number = extents[int(extent + 4)];
            var maxX:Number = extents[int(extent + 1)];
            var maxY:Number = extents[int(extent + 3)];
            var maxZ:Number = extents[int(extent + 5)];
            var limit:Number = _squared;
            var isProjected:Boolean = false;
            extents = mesh.extents;
            _triangles.setSecond(triangle, RelativeMotion.NONE);
            for (var i:int = first; i < end; i++)
            {
                extent = 6 * i;
                var squared:Number = 0;
                var distance:Number = extents[extent] - maxX;
                if (distance < 0)
                {
                    distance = minX - extents[int(extent + 1)];
                }
                if (distance > 0)
                {
                    squared = distance * distance;
                }
                distance = extents[int(extent + 2)] - maxY;
                if (distance < 0)
                {
                    distance = minY - extents[int(extent + 3)];
                }
                if (distance > 0)
                {
                    squared += distance * distance;
                }
                distance = extents[int(extent + 4)] - maxZ;
                if (distance < 0)
                {
                    distance = minZ - extents[int(extent + 5)];
                }
                if (distance > 0)
                {
                    squared += distance * distance;
                }
                if (squared >= limit)
                {
                    continue;
                }
                if (!isProjected)
                {
                    projectTo(corners, at);
                    isProjected = true;
                }
                if (!isBeyond(mesh.corners, 9 * i))
                {
                    _triangles.counts.triangleTests++;
                    _triangles.setFirst(i);
                    if (_triangles.pair.findCloser(_triangles.a, _triangles.b, _points))
                    {
                        limit = _squared = _points.distance * _points.distance;
                        isProjected = false;
                    }
                }
            }
        }

        // Measures a triangle of the second model along the line between the closest points so far.
        private function projectTo(corners:Vector.<Number>, at:int):void
        {
            var alongX:Number = _points.bX - _points.aX;
            var alongY:Number = _points.bY - _points.aY;
            var alongZ:Number = _points.bZ - _points.aZ;
            var p:Number = alongX * corners[at] + alongY * corners[int(at + 1)] + alongZ * corners[int(at + 2)];
            var q:Number = alongX * corners[int(at + 3)] + alongY * corners[int(at + 4)] + alongZ * corners[int(at + 5)];
            var r:Number = alongX * corners[int(at + 6)] + alongY * corners[int(at + 7)] + alongZ * corners[int(at + 8)];
            p = p < q ? p : q;
            p = p < r ? p : r;
            // The projections are scaled by the vector's length, so the nearest pair's distance becomes its square.
            _begin = p - _squared;
            _alongX = alongX;
            _alongY = alongY;
            _alongZ = alongZ;
        }

        // Whether a triangle of the first model is so far away along the line that the pair cannot be nearer than the nearest one.
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
