package starlogo.solid
{
    import starlogo.convex.ClosestPoints;
    import starlogo.convex.RelativeMotion;
    import starlogo.convex.TrianglePlane;
    import starlogo.engine;
    import starlogo.geometry.placePoints;
    import starlogo.hierarchy.TreeCounts;
    import starlogo.intersection.TriangleKernel;

    use namespace engine;

    /**
     * Decides by triangles about a node of tree a and a node of tree b: whether they touch, when they first do, and how far they are apart. The
     * triangles of b's node are placed in a's space, and kept as long as the next pairs have the same node. TriangleKernel decides about two triangles,
     * unless a quick test rules them out. TriangleContactFinder finds the contact of the two that touch first.
     */
    internal final class TrianglePairKernel
    {
        // The corners of a's current triangle, and its plane with the distance of quick tests: see TreePair.
        private var _cornersOfA:Vector.<Number> = new Vector.<Number>(9, true);
        private var _planeOfA:TrianglePlane = new TrianglePlane();

        // The two trees, and the motion of b, which ends at the first touch so far.
        private var _trees:TreePair = null;
        private var _motion:RelativeMotion = null;

        // The index of the first triangle that is placed, or -1.
        private var _firstPlaced:int = -1;

        // The corners of the triangles of b's node in a's space, by their index in the node: nine numbers each.
        private var _placed:Vector.<Number> = new Vector.<Number>();

        // The extents of b's current triangle and of its motion, with the distance of quick tests: minX, maxX, minY, ...
        private var _extents:Vector.<Number> = new Vector.<Number>(6, true);

        // Decides about b's current triangle, which is its shape, and triangles of a.
        private var _kernel:TriangleKernel = new TriangleKernel();

        private var _counts:TreeCounts;

        // The plane of b's current triangle.
        private var _planeOfB:TrianglePlane = new TrianglePlane();

        /** @param counts counts the pairs of triangles that are tested or measured */
        public function TrianglePairKernel(counts:TreeCounts)
        {
            _counts = counts;
        }

        /**
         * Begins with two trees. If they are exact, it can be asked about their leaves.
         *
         * @param trees the two; the pose is where b is at time 0
         * @param motion of b in a's space; RelativeMotion.NONE if it stands. <code>findEarlier()</code> overwrites its time and its latest time
         * @return this
         */
        public function begin(trees:TreePair, motion:RelativeMotion):TrianglePairKernel
        {
            _trees = trees;
            _motion = motion;
            _firstPlaced = -1;
            _planeOfA.cullDistance = trees.cullDistance(motion);
            return this;
        }

        /** Whether triangles of two leaves, which stand, touch. */
        public function areTouching(a:int, b:int):Boolean
        {
            var count:int = placeTriangles(b);
            var end:int = _trees.a.endPrimitive[a];
            for (var i:int = 0; i < count; i++)
            {
                setTriangleOfB(i);
                for (var indexA:int = _trees.a.firstPrimitive[a]; indexA < end; indexA++)
                {
                    if (areExtentsWithin(0, _extents, _trees.a, indexA))
                    {
                        _counts.triangleTests++;
                        if (!staysOnOneSide(indexA) && _kernel.areTouching(_cornersOfA))
                        {
                            return true;
                        }
                    }
                }
            }
            return false;
        }

        /**
         * Finds when triangles of two leaves first touch.
         *
         * @param impact the first touch so far; receives that of the two leaves if it counts as earlier
         */
        public function findEarlier(a:int, b:int, impact:FirstImpact):void
        {
            var first:int = _trees.a.firstPrimitive[a];
            var end:int = _trees.a.endPrimitive[a];
            // Higher indices come first, as the traversal visits the right child first if both bounds are equal.
            for (var i:int = placeTriangles(b) - 1; i >= 0 && impact.time > 0; i--)
            {
                setTriangleOfB(i);
                _planeOfB.setTriangle(_placed, 9 * i);
                for (var indexA:int = end - 1; indexA >= first && impact.time > 0; indexA--)
                {
                    if (!areExtentsWithin(0, _extents, _trees.a, indexA))
                    {
                        continue;
                    }
                    _counts.triangleTests++;
                    if (staysOnOneSide(indexA))
                    {
                        continue;
                    }
                    _kernel.findTimeOfImpact(_cornersOfA, _motion);
                    if (impact.offer(_motion, _planeOfA, _planeOfB))
                    {
                        impact.a = indexA;
                        impact.b = _firstPlaced + i;
                    }
                }
            }
        }

        /**
         * Finds the closest points of the triangles of two leaves.
         *
         * @param points the closest ones so far, and their distance; receives those of the two leaves if they are closer
         */
        public function findCloser(a:int, b:int, points:ClosestPoints):void
        {
            var count:int = placeTriangles(b);
            var end:int = _trees.a.endPrimitive[a];
            for (var i:int = 0; i < count && points.distance > 0; i++)
            {
                setTriangleOfB(i);
                for (var indexA:int = _trees.a.firstPrimitive[a]; indexA < end; indexA++)
                {
                    if (!areExtentsWithin(points.distance, _extents, _trees.a, indexA))
                    {
                        continue;
                    }
                    _trees.a.readTriangle(indexA, _cornersOfA);
                    if (isFartherAlongGap(i, points))
                    {
                        continue;
                    }
                    _counts.triangleTests++;
                    if (_kernel.findCloser(_cornersOfA, points))
                    {
                        // a's point first
                        points.swap();
                    }
                }
            }
        }

        // Places the triangles of a node of b in a's space, and returns their number. The node has no children: two such nodes do not begin with the
        // same triangle.
        private function placeTriangles(node:int):int
        {
            var first:int = _trees.b.firstPrimitive[node];
            var count:int = _trees.b.endPrimitive[node] - first;
            if (first != _firstPlaced)
            {
                _firstPlaced = first;
                for (var i:int = 0; i < count; i++)
                {
                    _trees.b.readTriangle(first + i, _placed, 9 * i);
                }
                placePoints(_trees.pose.placement, _placed, 0, 9 * count, _placed);
            }
            return count;
        }

        // Sets b's current triangle, by its index in the node. Its shape has the margin of both triangles. The motion may end earlier afterwards.
        private function setTriangleOfB(index:int):void
        {
            _kernel.shape.setTriangle(_placed, 9 * index);
            _kernel.shape.margin += _trees.triangleMargin;
            writeExtents(9 * index, 0, _motion.latestTime * _motion.x);
            writeExtents(9 * index + 1, 2, _motion.latestTime * _motion.y);
            writeExtents(9 * index + 2, 4, _motion.latestTime * _motion.z);
        }

        // Writes the extents of a placed triangle and of its motion along an axis: reads its first coordinate at one index, and writes to another.
        private function writeExtents(at:int, to:int, travel:Number):void
        {
            var first:Number = _placed[at];
            var second:Number = _placed[int(at + 3)];
            var third:Number = _placed[int(at + 6)];
            var low:Number = second < first ? second : first;
            var high:Number = second < first ? first : second;
            low = third < low ? third : low;
            high = third > high ? third : high;
            low -= _planeOfA.cullDistance;
            high += _planeOfA.cullDistance;
            _extents[to] = travel < 0 ? low + travel : low;
            _extents[int(to + 1)] = travel > 0 ? high + travel : high;
        }

        // Makes a triangle of a the current one. Returns whether b's current triangle stays on one side of its plane.
        private function staysOnOneSide(indexA:int):Boolean
        {
            _trees.a.readTriangle(indexA, _cornersOfA);
            _planeOfA.setTriangle(_cornersOfA, 0);
            return _planeOfA.timeOfEntry(_kernel.shape, _motion) > _motion.latestTime;
        }

        // Whether a's current triangle is so far before b's triangle, along the vector from the closest point so far of a to that of b, that the two
        // cannot be nearer. Places along the vector are scaled by its length, so the distance so far becomes its square. The triangle of b is projected
        // each time, because few pairs come here whose extents are near enough.
        private function isFartherAlongGap(index:int, points:ClosestPoints):Boolean
        {
            var at:int = 9 * index;
            var x:Number = points.b.x - points.a.x;
            var y:Number = points.b.y - points.a.y;
            var z:Number = points.b.z - points.a.z;
            var corners:Vector.<Number> = _placed;
            var least:Number = x * corners[at] + y * corners[int(at + 1)] + z * corners[int(at + 2)];
            var projection:Number = x * corners[int(at + 3)] + y * corners[int(at + 4)] + z * corners[int(at + 5)];
            least = projection < least ? projection : least;
            projection = x * corners[int(at + 6)] + y * corners[int(at + 7)] + z * corners[int(at + 8)];
            least = projection < least ? projection : least;
            var limit:Number = least - points.distance * points.distance;
            corners = _cornersOfA;
            return x * corners[0] + y * corners[1] + z * corners[2] <= limit && x * corners[3] + y * corners[4] + z * corners[5] <= limit
                && x * corners[6] + y * corners[7] + z * corners[8] <= limit;
        }
    }
}
