package starlogo.solid
{
    import starlogo.convex.ClosestPoints;
    import starlogo.convex.RelativeMotion;
    import starlogo.convex.TrianglePlane;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.hierarchy.BestPair;
    import starlogo.hierarchy.NodePairVisitor;
    import starlogo.hierarchy.TreeCounts;
    import starlogo.hierarchy.TriangleMesh;
    import starlogo.intersection.TriangleKernel;

    use namespace engine;

    /**
     * Decides by triangles about two nodes: whether they touch, when they first do, and how far they are apart. The triangles of the second node are
     * moved into the first model's space, and kept as long as it is the second node. TriangleKernel decides about two triangles, unless a quick test
     * rules them out. TriangleContactFinder finds the contact of the two that touch first.
     */
    internal final class TrianglePairVisitor extends NodePairVisitor
    {
        private var _firstMesh:TriangleMesh = null;
        private var _extentsOfFirst:Vector.<Number> = null;
        private var _cornersOfFirst:Vector.<Number> = new Vector.<Number>(9, true);
        private var _secondMesh:TriangleMesh = null;

        // The second model's placement in the first model's space, and its motion, which ends at the first touch so far.
        private var _placement:Placement = null;
        private var _motion:RelativeMotion = new RelativeMotion();

        // The slot of the first triangle of the second node, or -1 if no triangles are moved.
        private var _movedFrom:int = -1;

        // The corners of the moved triangles, by their index in the node: nine numbers each.
        private var _moved:Vector.<Number> = new Vector.<Number>();

        // The extents of the current triangle of the second node and of its motion, with the tolerance of quick tests: minX, maxX, minY, ...
        private var _extents:Vector.<Number> = new Vector.<Number>(6, true);

        // Decides about the current triangle of the second node, which is its shape, and triangles of the first model.
        private var _kernel:TriangleKernel = new TriangleKernel();

        private var _counts:TreeCounts;

        // The largest distance at which triangles touch, and that of quick tests: see TwoTrees.
        private var _tolerance:Number = 0;
        private var _outerTolerance:Number = 0;

        // The plane of the current triangle of the second node.
        private var _planeOfSecond:TrianglePlane = new TrianglePlane();

        // Chooses the triangles that touch first.
        private var _touch:FirstTouch = new FirstTouch();

        /** @param counts counts the pairs of triangles that are tested or measured */
        public function TrianglePairVisitor(counts:TreeCounts)
        {
            _counts = counts;
        }

        /**
         * Begins with two trees that have triangles.
         *
         * @param pair its pose is where the second model is at time 0
         * @param motion of the second model in the first model's space; RelativeMotion.NONE if it stands
         * @return this
         */
        public function begin(pair:TwoTrees, motion:RelativeMotion):NodePairVisitor
        {
            _placement = pair.pose.placement;
            _firstMesh = pair.a.mesh;
            _secondMesh = pair.b.mesh;
            _extentsOfFirst = _firstMesh.extents;
            _motion.copyVector(motion);
            _motion.latest = motion.latest;
            _touch.begin(motion.latest);
            _movedFrom = -1;
            _tolerance = pair.tolerance;
            _outerTolerance = pair.outerTolerance(motion);
            return this;
        }

        /** @inheritDoc */
        override public function areTouching(a:int, b:int):Boolean
        {
            var count:int = moveSecond(b);
            var end:int = _firstMesh.tree.end[a];
            for (var i:int = 0; i < count; i++)
            {
                setSecond(i);
                for (var slot:int = _firstMesh.tree.first[a]; slot < end; slot++)
                {
                    if (areExtentsNear(slot))
                    {
                        setFirst(slot);
                        if (areTrianglesTouching())
                        {
                            return true;
                        }
                    }
                }
            }
            return false;
        }

        /** @inheritDoc */
        override public function findImpact(a:int, b:int, best:BestPair):void
        {
            var motion:RelativeMotion = _motion;
            var first:int = _firstMesh.tree.first[a];
            var end:int = _firstMesh.tree.end[a];
            // Higher indices come first, as in the traversal.
            for (var i:int = moveSecond(b) - 1; i >= 0 && _touch.time > 0; i--)
            {
                setSecond(i);
                _planeOfSecond.setTriangle(_moved, 9 * i);
                for (var slot:int = end - 1; slot >= first && _touch.time > 0; slot--)
                {
                    if (!areExtentsNear(slot))
                    {
                        continue;
                    }
                    setFirst(slot);
                    if (findTime(motion))
                    {
                        if (_touch.choose(motion, _kernel.plane, _planeOfSecond))
                        {
                            best.a = slot;
                            best.b = _movedFrom + i;
                        }
                        best.time = _touch.time;
                        best.least = motion.latest = _touch.latest;
                    }
                }
            }
        }

        /** @inheritDoc */
        override public function findCloser(a:int, b:int, best:BestPair):void
        {
            var points:ClosestPoints = best.points;
            var count:int = moveSecond(b);
            var end:int = _firstMesh.tree.end[a];
            for (var i:int = 0; i < count && points.distance > 0; i++)
            {
                setSecond(i);
                for (var slot:int = _firstMesh.tree.first[a]; slot < end; slot++)
                {
                    findCloserPoints(slot, i, points);
                }
            }
            best.least = points.distance;
        }

        // Moves the triangles of a node of the second model, and returns their number. The node has no children: two such nodes do not begin with the
        // same triangle.
        private function moveSecond(node:int):int
        {
            var first:int = _secondMesh.tree.first[node];
            var count:int = _secondMesh.tree.end[node] - first;
            if (first != _movedFrom)
            {
                _movedFrom = first;
                for (var i:int = 0; i < count; i++)
                {
                    _secondMesh.readTriangle(first + i, _moved, 9 * i);
                }
                Placement.placePoints(_placement, _moved, 0, 9 * count, _moved);
            }
            return count;
        }

        // Sets the current triangle of the second node, by its index there. Its shape has the margin of both triangles. The motion may end earlier
        // afterwards.
        private function setSecond(index:int):void
        {
            _kernel.shape.setTriangle(_moved, 9 * index);
            _kernel.shape.margin += _tolerance;
            writeExtents(9 * index, 0, _motion.latest * _motion.x);
            writeExtents(9 * index + 1, 2, _motion.latest * _motion.y);
            writeExtents(9 * index + 2, 4, _motion.latest * _motion.z);
        }

        // Writes the extents of a moved triangle and of its motion along an axis: reads its first coordinate at one index, and writes to another.
        private function writeExtents(at:int, to:int, travel:Number):void
        {
            var p:Number = _moved[at];
            var q:Number = _moved[int(at + 3)];
            var r:Number = _moved[int(at + 6)];
            var low:Number = q < p ? q : p;
            var high:Number = q < p ? p : q;
            low = r < low ? r : low;
            high = r > high ? r : high;
            low -= _outerTolerance;
            high += _outerTolerance;
            _extents[to] = travel < 0 ? low + travel : low;
            _extents[int(to + 1)] = travel > 0 ? high + travel : high;
        }

        // Sets the current triangle of the first model, which is tested.
        private function setFirst(slot:int):void
        {
            _counts.triangleTests++;
            _firstMesh.readTriangle(slot, _cornersOfFirst);
            _kernel.setTriangle(_cornersOfFirst);
        }

        // Whether the two current triangles touch.
        private function areTrianglesTouching():Boolean
        {
            return !staysOnOneSide() && !TriangleSeparation.areApart(_cornersOfFirst, 0, _kernel.shape) && _kernel.areTouching();
        }

        // Finds when the two current triangles first touch. Sets the motion's time if that is no later than its latest time, and returns whether it is.
        private function findTime(motion:RelativeMotion):Boolean
        {
            if (staysOnOneSide())
            {
                return false;
            }
            _kernel.findTime(motion);
            return motion.time <= motion.latest;
        }

        // Finds the closest points of the second node's triangle, by its index there, and a triangle of the first model, if they are nearer than those
        // so far.
        private function findCloserPoints(slot:int, index:int, points:ClosestPoints):void
        {
            if (!(squaredDistanceOfExtents(slot) < points.distance * points.distance))
            {
                return;
            }
            _firstMesh.readTriangle(slot, _cornersOfFirst);
            if (!isBeyond(index, points))
            {
                _counts.triangleTests++;
                if (_kernel.findCloser(_cornersOfFirst, points))
                {
                    // the first model's point first
                    points.swap();
                }
            }
        }

        // Whether the extents of a triangle of the first model meet those of the second model's triangle and of its motion.
        private function areExtentsNear(slot:int):Boolean
        {
            var ofFirst:Vector.<Number> = _extentsOfFirst;
            var ofSecond:Vector.<Number> = _extents;
            var at:int = 6 * slot;
            return !(ofFirst[at] > ofSecond[1] || ofFirst[int(at + 1)] < ofSecond[0] || ofFirst[int(at + 2)] > ofSecond[3] || ofFirst[int(at + 3)] < ofSecond[2]
                    || ofFirst[int(at + 4)] > ofSecond[5] || ofFirst[int(at + 5)] < ofSecond[4]);
        }

        // Whether the current triangle of the second node stays on one side of the plane of the first model's.
        private function staysOnOneSide():Boolean
        {
            return _kernel.plane.findEntry(_kernel.shape, _outerTolerance, _motion) > _motion.latest;
        }

        // The squared distance of the extents of a triangle of the first model from those of the current triangle. Both are prepared, because each
        // triangle is compared with many; squaredDistanceToExtents() reads corners.
        private function squaredDistanceOfExtents(slot:int):Number
        {
            var ofFirst:Vector.<Number> = _extentsOfFirst;
            var ofSecond:Vector.<Number> = _extents;
            var at:int = 6 * slot;
            var squared:Number = 0;
            for (var i:int = 0; i < 6; i += 2)
            {
                var above:Number = ofFirst[int(at + i)] - ofSecond[int(i + 1)];
                var below:Number = ofSecond[i] - ofFirst[int(at + i + 1)];
                var distance:Number = above > below ? above : below;
                if (distance > 0)
                {
                    squared += distance * distance;
                }
            }
            return squared;
        }

        // Whether the triangle of the first model is so far before the second model's triangle, along the vector from the first model's closest point so
        // far to the second's, that the two cannot be nearer. Places along it are scaled by its length, so the distance so far becomes its square. The
        // second one is projected each time, because few pairs come here whose extents are near enough.
        private function isBeyond(index:int, points:ClosestPoints):Boolean
        {
            var second:int = 9 * index;
            var x:Number = points.b.x - points.a.x;
            var y:Number = points.b.y - points.a.y;
            var z:Number = points.b.z - points.a.z;
            var corners:Vector.<Number> = _moved;
            var p:Number = x * corners[second] + y * corners[int(second + 1)] + z * corners[int(second + 2)];
            var q:Number = x * corners[int(second + 3)] + y * corners[int(second + 4)] + z * corners[int(second + 5)];
            var r:Number = x * corners[int(second + 6)] + y * corners[int(second + 7)] + z * corners[int(second + 8)];
            p = p < q ? p : q;
            p = p < r ? p : r;
            var end:Number = p - points.distance * points.distance;
            corners = _cornersOfFirst;
            return x * corners[0] + y * corners[1] + z * corners[2] <= end && x * corners[3] + y * corners[4] + z * corners[5] <= end
                && x * corners[6] + y * corners[7] + z * corners[8] <= end;
        }
    }
}
