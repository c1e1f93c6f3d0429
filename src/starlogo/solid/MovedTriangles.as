package starlogo.solid
{
    import starlogo.convex.ClosestPoints;
    import starlogo.convex.ContactPoint;
    import starlogo.convex.ConvexKernel;
    import starlogo.convex.ConvexShape;
    import starlogo.convex.RelativeMotion;
    import starlogo.convex.TrianglePlane;
    import starlogo.engine;
    import starlogo.geometry.Tolerances;
    import starlogo.geometry.Touching;
    import starlogo.hierarchy.BoxTree;
    import starlogo.hierarchy.RelativePose;
    import starlogo.hierarchy.TreeCounts;

    use namespace engine;

    /**
     * The triangles of one node of the second model, moved into the first model's space, and what decides about one of them and a triangle of the
     * first model. <code>begin()</code> sets the models, <code>move()</code> the node, and <code>setSecond()</code> the triangle of the node. A
     * triangle of each is a shape. ConvexKernel decides about the two, unless a quick test rules them out. The second one moves there, if one does.
     */
    internal final class MovedTriangles
    {
        private var _firstMesh:TriangleMesh = null;
        private var _secondMesh:TriangleMesh = null;

        // The second model's pose in the first model's space.
        private var _pose:RelativePose = null;

        // The slot of the first triangle of the node of the last move(), or -1.
        private var _movedFrom:int = -1;

        // The corners of the triangles of that node, by index: nine numbers each. Their extents: minX, maxX, minY, maxY, minZ, maxZ of each.
        private var _moved:Vector.<Number> = new Vector.<Number>();
        private var _extents:Vector.<Number> = new Vector.<Number>();

        // The index of the second model's triangle in the node.
        private var _index:int = 0;

        // The extents of the second model's triangle and of its motion, with the tolerance of quick tests: minX, maxX, minY, ...
        private var _extentsOfSecond:Vector.<Number> = new Vector.<Number>(6, true);

        // A triangle of the first model, a triangle of the second, and what decides about them.
        private var _first:ConvexShape = new ConvexShape();
        private var _second:ConvexShape = new ConvexShape();
        private var _kernel:ConvexKernel = new ConvexKernel();

        private var _counts:TreeCounts;

        // The largest distance at which triangles of these models touch.
        private var _tolerance:Number = 0;

        // The tolerance of quick tests, which is larger: it includes the margin of the motion and Tolerances.CORES of the two triangles. A second
        // tolerance is more than those CORES, because it has SURFACES of the radii.
        private var _outerTolerance:Number = 0;

        // The plane of a triangle of the first model.
        private var _plane:TrianglePlane = new TrianglePlane();

        /** @param counts counts the pairs of triangles that are tested or measured */
        public function MovedTriangles(counts:TreeCounts)
        {
            _counts = counts;
        }

        /** Begins with two models that have triangles. The pose must relate them already, and the motion is the second one's. */
        public function begin(a:ModelTree, b:ModelTree, pose:RelativePose, motion:RelativeMotion):void
        {
            // Writing an object to a field costs Adobe's VM more than comparing it first.
            if (_pose !== pose)
            {
                _pose = pose;
            }
            _firstMesh = a.prepareMesh();
            _secondMesh = b.prepareMesh();
            _firstMesh.prepareExtents();
            _movedFrom = -1;
            _tolerance = pose.tolerance + Touching.marginOfSurface(a.boxTree.radius + b.boxTree.radius * pose.placement.size);
            _outerTolerance = 2 * _tolerance + Tolerances.EXTENTS * (Math.abs(motion.x) + Math.abs(motion.y) + Math.abs(motion.z));
        }

        /**
         * Computes the triangles of a node of the second model, and returns their number. If the node is the same as the last one, they are kept.
         *
         * @param node without children: two such nodes do not begin with the same triangle
         */
        public function move(tree:BoxTree, node:int):int
        {
            var first:int = tree.first[node];
            var count:int = tree.end[node] - first;
            if (first == _movedFrom)
            {
                return count;
            }
            _movedFrom = first;
            _pose.placement.placePoints(_secondMesh.corners, 9 * first, 9 * (first + count), _moved);
            var corners:Vector.<Number> = _moved;
            var spans:Vector.<Number> = _extents;
            if (spans.length < 6 * count)
            {
                spans.length = 6 * count;
            }
            for (var i:int = 0; i < count; i++)
            {
                writeTriangleExtents(corners, 9 * i, spans, 6 * i);
            }
            return count;
        }

        /**
         * Sets the second model's triangle for the pairs that follow. Its shape has the margin of both.
         *
         * @param index its index in the node
         * @param motion of the second model; RelativeMotion.NONE if it stands. Its latest time may become earlier afterwards
         */
        public function setSecond(index:int, motion:RelativeMotion):void
        {
            _index = index;
            _second.setTriangle(_moved, 9 * index);
            _second.margin += _tolerance;
            writeExtentsOfSecond(0, motion.latest * motion.x);
            writeExtentsOfSecond(2, motion.latest * motion.y);
            writeExtentsOfSecond(4, motion.latest * motion.z);
        }

        // Writes the extents of the second model's triangle and of its motion along an axis.
        private function writeExtentsOfSecond(axis:int, travel:Number):void
        {
            var at:int = 6 * _index + axis;
            var low:Number = _extents[at] - _outerTolerance;
            var high:Number = _extents[int(at + 1)] + _outerTolerance;
            _extentsOfSecond[axis] = travel < 0 ? low + travel : low;
            _extentsOfSecond[int(axis + 1)] = travel > 0 ? high + travel : high;
        }

        /** Whether a triangle of the first model, by its slot, touches the second model's triangle, which stands. */
        public function touches(slot:int):Boolean
        {
            if (!areExtentsNear(slot))
            {
                return false;
            }
            _counts.triangleTests++;
            if (stayApart(slot, RelativeMotion.NONE) || TriangleSeparation.areApart(_firstMesh.corners, 9 * slot, _second))
            {
                return false;
            }
            _first.setTriangle(_firstMesh.corners, 9 * slot);
            return _kernel.areTouching(_first, _second);
        }

        /**
         * Finds when the second model's triangle first touches a triangle of the first model.
         *
         * @param slot the first model's triangle
         * @param motion of the second model; receives the time if the two touch until its latest time
         * @return whether they do
         */
        public function findTime(slot:int, motion:RelativeMotion):Boolean
        {
            if (!areExtentsNear(slot))
            {
                return false;
            }
            _counts.triangleTests++;
            if (stayApart(slot, motion))
            {
                return false;
            }
            _first.setTriangle(_firstMesh.corners, 9 * slot);
            _kernel.findTime(_second, _first, motion);
            return motion.time <= motion.latest;
        }

        /**
         * Measures the distance of the second model's triangle, which stands, from a triangle of the first model.
         *
         * @param slot the first model's triangle
         * @param points the closest points so far; receives those of the two if they are nearer
         * @return whether they are
         */
        public function findCloser(slot:int, points:ClosestPoints):Boolean
        {
            if (squaredDistanceOfExtents(slot) >= points.distance * points.distance || isBeyond(slot, points))
            {
                return false;
            }
            _counts.triangleTests++;
            _first.setTriangle(_firstMesh.corners, 9 * slot);
            return _kernel.findCloser(_first, _second, points);
        }

        /**
         * Finds the contact of two triangles that touch, in the first model's space. Afterwards, no triangle is moved.
         *
         * @param first the slot of the first model's triangle
         * @param second the slot of the second model's triangle
         * @param motion of the second model, which is where it is at the motion's time
         * @param out receives the contact, with a normal from the first model to the second
         */
        public function findContact(first:int, second:int, motion:RelativeMotion, out:ContactPoint):void
        {
            _movedFrom = -1;
            _pose.placement.placePoints(_secondMesh.corners, 9 * second, 9 * second + 9, _moved);
            _first.setTriangle(_firstMesh.corners, 9 * first);
            _second.setTriangle(_moved, 0);
            _kernel.findContact(_second, _first, motion, out);
        }

        // Whether the extents of a triangle of the first model meet those of the second model's triangle and of its motion.
        private function areExtentsNear(slot:int):Boolean
        {
            var ofFirst:Vector.<Number> = _firstMesh.extents;
            var ofSecond:Vector.<Number> = _extentsOfSecond;
            var at:int = 6 * slot;
            return !(ofFirst[at] > ofSecond[1] || ofFirst[int(at + 1)] < ofSecond[0] || ofFirst[int(at + 2)] > ofSecond[3] || ofFirst[int(at + 3)] < ofSecond[2]
                    || ofFirst[int(at + 4)] > ofSecond[5] || ofFirst[int(at + 5)] < ofSecond[4]);
        }

        // Whether the second model's triangle stays on one side of the plane of a triangle of the first model.
        private function stayApart(slot:int, motion:RelativeMotion):Boolean
        {
            _plane.setTriangle(_firstMesh.corners, 9 * slot);
            return _plane.findEntry(_second, _outerTolerance, motion) > motion.latest;
        }

        // The squared distance of the extents of a triangle of the first model and of the second model's triangle.
        private function squaredDistanceOfExtents(slot:int):Number
        {
            var ofFirst:Vector.<Number> = _firstMesh.extents;
            var ofSecond:Vector.<Number> = _extents;
            var a:int = 6 * slot;
            var b:int = 6 * _index;
            var squared:Number = 0;
            for (var end:int = a + 6; a < end; a += 2)
            {
                var distance:Number = ofFirst[a] - ofSecond[int(b + 1)];
                if (distance < 0)
                {
                    distance = ofSecond[b] - ofFirst[int(a + 1)];
                }
                if (distance > 0)
                {
                    squared += distance * distance;
                }
                b += 2;
            }
            return squared;
        }

        // Whether a triangle of the first model is so far before the second model's triangle, along the vector from the first model's closest point so
        // far to the second's, that the two cannot be nearer. Places along it are scaled by its length, so the distance so far becomes its square. The
        // second one is projected each time, because few pairs come here whose extents are near enough.
        private function isBeyond(slot:int, points:ClosestPoints):Boolean
        {
            var x:Number = points.bX - points.aX;
            var y:Number = points.bY - points.aY;
            var z:Number = points.bZ - points.aZ;
            var corners:Vector.<Number> = _moved;
            var at:int = 9 * _index;
            var p:Number = x * corners[at] + y * corners[int(at + 1)] + z * corners[int(at + 2)];
            var q:Number = x * corners[int(at + 3)] + y * corners[int(at + 4)] + z * corners[int(at + 5)];
            var r:Number = x * corners[int(at + 6)] + y * corners[int(at + 7)] + z * corners[int(at + 8)];
            p = p < q ? p : q;
            p = p < r ? p : r;
            var end:Number = p - points.distance * points.distance;
            corners = _firstMesh.corners;
            at = 9 * slot;
            return x * corners[at] + y * corners[int(at + 1)] + z * corners[int(at + 2)] <= end
                && x * corners[int(at + 3)] + y * corners[int(at + 4)] + z * corners[int(at + 5)] <= end
                && x * corners[int(at + 6)] + y * corners[int(at + 7)] + z * corners[int(at + 8)] <= end;
        }
    }
}
