package starlogo.solid
{
    import flash.geom.Vector3D;
    import starlogo.bounding.Sphere;
    import starlogo.convex.ClosestPoints;
    import starlogo.convex.ContactPoint;
    import starlogo.convex.RelativeMotion;
    import starlogo.convex.TrianglePlane;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.geometry.Tolerances;
    import starlogo.geometry.Touching;
    import starlogo.hierarchy.BestPair;
    import starlogo.hierarchy.NodePairVisitor;
    import starlogo.hierarchy.RelativePose;
    import starlogo.hierarchy.TreeCounts;
    import starlogo.hierarchy.TriangleMesh;
    import starlogo.intersection.TriangleKernel;

    use namespace engine;

    /**
     * Decides by triangles about two nodes: whether they touch, when they first do, and how far they are apart. The triangles of the second node are
     * moved into the first model's space, and kept as long as it is the second node. TriangleKernel decides about two triangles, unless a quick test
     * rules them out.
     */
    internal final class TrianglePairVisitor extends NodePairVisitor
    {
        // The radius of the probe, as a fraction of the extent of a triangle that it is near. Smaller: rounding decides. Larger: the probe meets what is
        // not at the contact.
        private static const PROBE:Number = 1e-4;

        // How far the probe is behind a plane, as a fraction of its radius. Smaller: the probe meets what is in the plane. Larger: it misses what leaves
        // the plane at a small angle, of the square root of twice this fraction.
        private static const PROBE_GAP:Number = 1e-6;

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

        // The largest distance at which triangles of these models touch.
        private var _tolerance:Number = 0;

        // The tolerance of quick tests, which is larger: it includes the margin of the motion and Tolerances.CORES of the two triangles. A second
        // tolerance is more than those CORES, because it has SURFACES of the radii.
        private var _outerTolerance:Number = 0;

        // The plane of the current triangle of the second node.
        private var _planeOfSecond:TrianglePlane = new TrianglePlane();

        // Chooses the triangles that touch first.
        private var _touch:FirstTouch = new FirstTouch();

        // A small ball behind a plane at a contact, in the first model's space, and what finds triangles there: with the pose of that space in the space
        // of each model, and the motion of a ball that stands.
        private var _probe:Sphere = new Sphere(new Vector3D(), 0);
        private var _touches:TriangleTouchVisitor;
        private var _toFirst:RelativePose = new RelativePose();
        private var _toSecond:RelativePose = new RelativePose();
        private var _still:RelativeMotion = new RelativeMotion();

        // The first model's motion, if the second one stands.
        private var _reversed:RelativeMotion = new RelativeMotion();

        /** @param counts counts the pairs of triangles that are tested or measured */
        public function TrianglePairVisitor(counts:TreeCounts)
        {
            _counts = counts;
            _touches = new TriangleTouchVisitor(counts);
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
            _tolerance = pair.pose.tolerance + Touching.marginOfSurface(pair.a.boxTree.radius + pair.b.boxTree.radius * _placement.size);
            _outerTolerance = 2 * _tolerance + Tolerances.EXTENTS * (Math.abs(motion.x) + Math.abs(motion.y) + Math.abs(motion.z));
            return this;
        }

        /** @inheritDoc */
        override public function areTouching(a:int, b:int):Boolean
        {
            var count:int = move(b);
            var end:int = _firstMesh.tree.end[a];
            for (var i:int = 0; i < count; i++)
            {
                setSecond(i);
                for (var slot:int = _firstMesh.tree.first[a]; slot < end; slot++)
                {
                    if (touches(slot))
                    {
                        return true;
                    }
                }
            }
            return false;
        }

        /** @inheritDoc */
        override public function findTouch(a:int, b:int, best:BestPair):void
        {
            var motion:RelativeMotion = _motion;
            var first:int = _firstMesh.tree.first[a];
            var end:int = _firstMesh.tree.end[a];
            // Higher indices come first, as in the traversal.
            for (var i:int = move(b) - 1; i >= 0 && _touch.time > 0; i--)
            {
                setSecond(i);
                _planeOfSecond.setTriangle(_moved, 9 * i);
                for (var slot:int = end - 1; slot >= first && _touch.time > 0; slot--)
                {
                    if (findTime(slot))
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
            var count:int = move(b);
            var end:int = _firstMesh.tree.end[a];
            for (var i:int = 0; i < count && points.distance > 0; i++)
            {
                setSecond(i);
                for (var slot:int = _firstMesh.tree.first[a]; slot < end; slot++)
                {
                    findCloserPoints(slot, 9 * i, points);
                }
            }
            best.least = points.distance;
        }

        /**
         * Finds the contact of two triangles that touch, in the first model's space. If they meet at their borders, faces of both may separate them. A
         * face counts if it separates all of the other model at the contact: the next triangle may be on the other side of a seam.
         *
         * @param pair the two trees
         * @param best has the slots of the triangles
         * @param motion of the second model, which is where it is at the motion's time; its start must be 0
         * @param out receives the contact, with a normal from the first model to the second
         */
        public function findContact(pair:TwoTrees, best:BestPair, motion:RelativeMotion, out:ContactPoint):void
        {
            _movedFrom = -1;
            _secondMesh.readTriangle(best.b, _moved);
            _firstMesh.readTriangle(best.a, _cornersOfFirst);
            _kernel.setShapeToTriangle(_moved, _placement);
            _kernel.setTriangle(_cornersOfFirst);
            _kernel.findContact(motion, out);
            _kernel.shape.margin = _outerTolerance;
            Placement.invert(_placement, _toSecond.placement);
            var plane:TrianglePlane = _kernel.plane;
            if (plane.isMetBy(_kernel.shape, motion, out) && !hasTriangleBehind(pair.b, _toSecond, motion, out))
            {
                out.setNormal(plane.normal.x, plane.normal.y, plane.normal.z);
                return;
            }
            Placement.placePoints(_placement, _moved, 0, 9, _moved);
            _kernel.setTriangle(_moved);
            _kernel.shape.setTriangle(_cornersOfFirst, 0);
            _kernel.shape.margin = _outerTolerance;
            _reversed.setReversed(motion);
            if (plane.isMetBy(_kernel.shape, _reversed, out) && !hasTriangleBehind(pair.a, _toFirst, RelativeMotion.NONE, out))
            {
                out.setNormal(-plane.normal.x, -plane.normal.y, -plane.normal.z);
            }
        }

        // Whether a model has a triangle at a contact that is, at least in part, behind the plane. The kernel's shape is its triangle that touches there.
        private function hasTriangleBehind(model:ModelTree, pose:RelativePose, motion:RelativeMotion, contact:ContactPoint):Boolean
        {
            var radius:Number = PROBE * _kernel.shape.extent;
            var back:Number = (1 + PROBE_GAP) * radius + 2 * _tolerance;
            var normal:Vector3D = _kernel.plane.normal;
            _probe.radius = radius;
            _probe.center.x = contact.x - motion.time * motion.x - back * normal.x;
            _probe.center.y = contact.y - motion.time * motion.y - back * normal.y;
            _probe.center.z = contact.z - motion.time * motion.z - back * normal.z;
            return _touches.findTouch(model, _probe, pose, _still) >= 0;
        }

        // Moves the triangles of a node of the second model, and returns their number. The node has no children: two such nodes do not begin with the
        // same triangle.
        private function move(node:int):int
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

        // Whether a triangle of the first model, by its slot, touches the current one.
        private function touches(slot:int):Boolean
        {
            if (!areExtentsNear(slot))
            {
                return false;
            }
            _counts.triangleTests++;
            if (stayApart(slot) || TriangleSeparation.areApart(_cornersOfFirst, 0, _kernel.shape))
            {
                return false;
            }
            return _kernel.areTouching();
        }

        // Finds when the current triangle first touches a triangle of the first model. Sets the motion's time if that is no later than its latest time,
        // and returns whether it is.
        private function findTime(slot:int):Boolean
        {
            if (!areExtentsNear(slot))
            {
                return false;
            }
            _counts.triangleTests++;
            if (stayApart(slot))
            {
                return false;
            }
            _kernel.findTime(_motion);
            return _motion.time <= _motion.latest;
        }

        // Finds the closest points of the current triangle and a triangle of the first model, if they are nearer than those so far. The current one's
        // corners begin at an index.
        private function findCloserPoints(slot:int, second:int, points:ClosestPoints):void
        {
            if (!(squaredDistanceOfExtents(slot) < points.distance * points.distance))
            {
                return;
            }
            _firstMesh.readTriangle(slot, _cornersOfFirst);
            if (!isBeyond(second, points))
            {
                _counts.triangleTests++;
                _kernel.findCloser(_cornersOfFirst, points);
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

        // Goes on to a triangle of the first model. Whether the second model's triangle stays on one side of its plane.
        private function stayApart(slot:int):Boolean
        {
            _firstMesh.readTriangle(slot, _cornersOfFirst);
            _kernel.setTriangle(_cornersOfFirst);
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
        private function isBeyond(second:int, points:ClosestPoints):Boolean
        {
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
