package starlogo.solid
{
    import starlogo.convex.ClosestPoints;
    import starlogo.convex.RelativeMotion;
    import starlogo.engine;
    import starlogo.hierarchy.BoxTree;
    import starlogo.hierarchy.NodePairBounds;
    import starlogo.hierarchy.NodePairSearch;
    import starlogo.hierarchy.RelativePose;
    import starlogo.hierarchy.TreeCounts;

    use namespace engine;

    /** Finds the distance of the triangles of two nodes. It measures only pairs whose extents are nearer than the nearest pair so far. */
    internal final class TrianglePairDistance extends NodePairSearch
    {
        private var _triangles:MovedTriangles;

        // The closest points of the nearest pair so far. The place beyond which a triangle of the first model may be nearer, along the vector
        // from the first model's point to the second's.
        private var _points:ClosestPoints;
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
        public function begin(a:ModelTree, b:ModelTree, pose:RelativePose, points:ClosestPoints):NodePairSearch
        {
            _triangles.begin(a, b, pose, RelativeMotion.NONE);
            _points = points;
            return this;
        }

        /** @inheritDoc */
        override public function findBest(treeA:BoxTree, a:int, treeB:BoxTree, b:int, bounds:NodePairBounds):void
        {
            var count:int = _triangles.move(treeB, b);
            for (var i:int = 0; i < count && _points.distance > 0; i++)
            {
                addTriangle(treeA.first[a], treeA.end[a], i);
            }
            bounds.current = _points.distance;
        }

        // Adds each of the first model's triangles in a range of slots, paired with a triangle of the second model's node.
        private function addTriangle(first:int, end:int, index:int):void
        {
            var limit:Number = _points.distance * _points.distance;
            var isProjected:Boolean = false;
            _triangles.setSecond(index, RelativeMotion.NONE);
            for (var i:int = first; i < end; i++)
            {
                if (squaredDistanceOfExtents(i, index) >= limit)
                {
                    continue;
                }
                if (!isProjected)
                {
                    projectTo(_triangles.moved, 9 * index);
                    isProjected = true;
                }
                if (!isBeyond(_triangles.meshA.corners, 9 * i))
                {
                    _triangles.counts.triangleTests++;
                    _triangles.setFirst(i);
                    if (_triangles.pair.findCloser(_triangles.a, _triangles.b, _points))
                    {
                        limit = _points.distance * _points.distance;
                        isProjected = false;
                    }
                }
            }
        }

        // The squared distance of the extents of a triangle of the first model and one of the second model's node.
        private function squaredDistanceOfExtents(slot:int, index:int):Number
        {
            var ofA:Vector.<Number> = _triangles.meshA.extents;
            var ofB:Vector.<Number> = _triangles.extents;
            var a:int = 6 * slot;
            var b:int = 6 * index;
            var squared:Number = 0;
            for (var end:int = a + 6; a < end; a += 2)
            {
                var distance:Number = ofA[a] - ofB[int(b + 1)];
                if (distance < 0)
                {
                    distance = ofB[b] - ofA[int(a + 1)];
                }
                if (distance > 0)
                {
                    squared += distance * distance;
                }
                b += 2;
            }
            return squared;
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
            _begin = p - _points.distance * _points.distance;
        }

        // Whether a triangle of the first model is so far away along the line that the pair cannot be nearer than the nearest one.
        private function isBeyond(corners:Vector.<Number>, at:int):Boolean
        {
            var alongX:Number = _points.bX - _points.aX;
            var alongY:Number = _points.bY - _points.aY;
            var alongZ:Number = _points.bZ - _points.aZ;
            var begin:Number = _begin;
            return alongX * corners[at] + alongY * corners[int(at + 1)] + alongZ * corners[int(at + 2)] <= begin
                && alongX * corners[int(at + 3)] + alongY * corners[int(at + 4)] + alongZ * corners[int(at + 5)] <= begin
                && alongX * corners[int(at + 6)] + alongY * corners[int(at + 7)] + alongZ * corners[int(at + 8)] <= begin;
        }
    }
}
