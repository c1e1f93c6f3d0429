package starlogo.solid
{
    import starlogo.convex.ConvexPair;
    import starlogo.convex.ConvexShape;
    import starlogo.convex.RelativeMotion;
    import starlogo.engine;
    import starlogo.geometry.Tolerances;
    import starlogo.geometry.Touching;
    import starlogo.hierarchy.BoxTree;
    import starlogo.hierarchy.RelativePose;
    import starlogo.hierarchy.TreeCounts;

    use namespace engine;

    /**
     * Two models' triangles in one space: those of the first model as they are, by slot, and those of one node of the second model, moved, by their
     * index in the node. A triangle of each is a shape, and ConvexPair decides about the two.
     */
    internal final class MovedTriangles
    {
        public var meshA:TriangleMesh = null;
        public var meshB:TriangleMesh = null;

        /** The corners of the triangles of the node of the last <code>move()</code>, by index: nine numbers each. */
        public var moved:Vector.<Number> = new Vector.<Number>();

        /** The extents of these triangles: minX, maxX, minY, maxY, minZ, maxZ of each. */
        public var extents:Vector.<Number> = new Vector.<Number>();

        /** A triangle of the first model, a triangle of the second, and what decides about them. */
        public var a:ConvexShape = new ConvexShape();
        public var b:ConvexShape = new ConvexShape();
        public var pair:ConvexPair = new ConvexPair();

        /** Counts the pairs of triangles that are tested or measured. */
        public var counts:TreeCounts;

        // The largest distance at which triangles of these models touch.
        private var _tolerance:Number = 0;

        // The tolerance of quick tests, which is larger: it includes the margin of the motion and Tolerances.CORES of the two triangles. A second
        // tolerance is more than those CORES, because it has SURFACES of the radii.
        private var _outerTolerance:Number = 0;

        // How far off a plane corners have to be to be certainly on one side of it.
        private var _off:Number = 0;

        // The extents of the second model's triangle and of its motion, with the tolerance of quick tests: minX, maxX, minY, ...
        private var _extentsOfB:Vector.<Number> = new Vector.<Number>(6, true);

        // The second model's pose in the first model's space.
        private var _pose:RelativePose = null;

        // The first triangle of the node of the last move(), or -1.
        private var _first:int = -1;

        /** @param counts counts the pairs of triangles */
        public function MovedTriangles(counts:TreeCounts)
        {
            this.counts = counts;
        }

        /** Begins with two models that have triangles. The pose must relate them already, and the motion is the second one's. */
        public function begin(a:ModelTree, b:ModelTree, pose:RelativePose, motion:RelativeMotion):void
        {
            // Writing an object to a field costs Adobe's VM more than comparing it first.
            if (_pose !== pose)
            {
                _pose = pose;
            }
            meshA = a.prepareMesh();
            meshB = b.prepareMesh();
            meshA.prepareExtents();
            _first = -1;
            _tolerance = pose.tolerance + Touching.marginOfSurface(a.boxTree.radius + b.boxTree.radius * pose.placement.size);
            _outerTolerance = 2 * _tolerance + Tolerances.EXTENTS * (Math.abs(motion.x) + Math.abs(motion.y) + Math.abs(motion.z));
            _off = _outerTolerance + meshA.flatness;
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
            if (first == _first)
            {
                return count;
            }
            _first = first;
            _pose.placement.placePoints(meshB.corners, 9 * first, 9 * (first + count), moved);
            var corners:Vector.<Number> = moved;
            var spans:Vector.<Number> = extents;
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
         * Whether a triangle of the first model may touch the second model's current triangle until the motion's latest time. Quick tests of extents
         * and planes. If the extents are near, it counts the pair. The first model's planes must be prepared.
         *
         * @param slot the first model's triangle
         * @param index the second model's triangle, which is that of the last <code>setSecond()</code>
         * @param motion of the second model; RelativeMotion.NONE if it stands
         */
        public function mayTouch(slot:int, index:int, motion:RelativeMotion):Boolean
        {
            var ofA:Vector.<Number> = meshA.extents;
            var ofB:Vector.<Number> = _extentsOfB;
            var at:int = 6 * slot;
            if (ofA[at] > ofB[1] || ofA[int(at + 1)] < ofB[0] || ofA[int(at + 2)] > ofB[3] || ofA[int(at + 3)] < ofB[2] || ofA[int(at + 4)] > ofB[5]
                    || ofA[int(at + 5)] < ofB[4])
            {
                return false;
            }
            counts.triangleTests++;
            return !stayApart(slot, index, motion);
        }

        // Whether the second model's triangle stays on one side of the plane of the first one's.
        private function stayApart(slot:int, index:int, motion:RelativeMotion):Boolean
        {
            var planes:Vector.<Number> = meshA.planes;
            var corners:Vector.<Number> = moved;
            var at:int = 4 * slot;
            var corner:int = 9 * index;
            var x:Number = planes[at];
            var y:Number = planes[int(at + 1)];
            var z:Number = planes[int(at + 2)];
            var place:Number = planes[int(at + 3)];
            var p:Number = x * corners[corner] + y * corners[int(corner + 1)] + z * corners[int(corner + 2)] - place;
            var q:Number = x * corners[int(corner + 3)] + y * corners[int(corner + 4)] + z * corners[int(corner + 5)] - place;
            var r:Number = x * corners[int(corner + 6)] + y * corners[int(corner + 7)] + z * corners[int(corner + 8)] - place;
            var travel:Number = motion.latest * (x * motion.x + y * motion.y + z * motion.z);
            var low:Number = travel < 0 ? _off - travel : _off;
            var high:Number = travel > 0 ? -_off - travel : -_off;
            return p > low && q > low && r > low || p < high && q < high && r < high;
        }

        /** Sets the shapes of a triangle of each model, by their slots, without a margin. */
        public function setPair(first:int, second:int):void
        {
            setFirst(first);
            _first = -1;
            _pose.placement.placePoints(meshB.corners, 9 * second, 9 * second + 9, moved);
            b.setTriangle(moved, 0);
        }

        /** Sets the shape of the first model's triangle. */
        public function setFirst(slot:int):void
        {
            a.setTriangle(meshA.corners, 9 * slot);
        }

        /**
         * Sets the shape of the second model's triangle. It has the margin of both.
         *
         * @param index its index in the node
         * @param motion of the second model; RelativeMotion.NONE if it stands. Its latest time may become earlier afterwards
         */
        public function setSecond(index:int, motion:RelativeMotion):void
        {
            b.setTriangle(moved, 9 * index);
            b.margin += _tolerance;
            widen(6 * index, 0, motion.latest * motion.x);
            widen(6 * index, 2, motion.latest * motion.y);
            widen(6 * index, 4, motion.latest * motion.z);
        }

        // Writes the extents of the second model's triangle and of its motion along an axis.
        private function widen(at:int, axis:int, travel:Number):void
        {
            var low:Number = extents[int(at + axis)] - _outerTolerance;
            var high:Number = extents[int(at + axis + 1)] + _outerTolerance;
            _extentsOfB[axis] = travel < 0 ? low + travel : low;
            _extentsOfB[int(axis + 1)] = travel > 0 ? high + travel : high;
        }
    }
}
