package starlogo.intersection
{
    import flash.geom.Vector3D;
    import starlogo.bounding.Box;
    import starlogo.intersection.distance.DistanceResult;

    /**
     * Finds the point on the edges of one box that is nearest to another box, in the other box's axes. The point is a corner, unless the
     * distance gets smaller from both ends of an edge. In that case the distance is convex along the edge, and its minimum lies between the
     * ends.
     *
     * <p>If two boxes are apart, their closest points can be chosen so that one of them is on an edge: two points inside of faces can be
     * moved together until one reaches the rim of its face. If two boxes overlap, an edge of one reaches into the other, or one box is
     * inside of the other.</p>
     */
    internal final class BoxEdgeDistance extends CapsuleBoxKernel
    {
        // Two distances count as equal if they differ by less than this fraction of the box or the distance.
        private static const NEARER:Number = 1e-15;

        // For each edge, the axis that it is along and its two corners, all times 3.
        private static const EDGES:Vector.<int> = new <int>[
                0, 0, 3, 0, 6, 9, 0, 12, 15, 0, 18, 21,
                3, 0, 6, 3, 3, 9, 3, 12, 18, 3, 15, 21,
                6, 0, 12, 6, 3, 15, 6, 6, 18, 6, 9, 21];

        /** The square of the smallest distance. */
        public var squared:Number;

        // The box's middle, as seen from the other box's middle.
        private var _middleX:Number;
        private var _middleY:Number;
        private var _middleZ:Number;

        // The point on the edges, as seen from the other box's middle, and as seen from the other box's closest point.
        private var _pointX:Number;
        private var _pointY:Number;
        private var _pointZ:Number;
        private var _fromOtherX:Number;
        private var _fromOtherY:Number;
        private var _fromOtherZ:Number;

        // Half of each edge as a vector in the other box's axes: first the edges along axisX, then axisY, then axisZ.
        private var _halves:Vector.<Number> = new Vector.<Number>(9, true);

        // For each corner, its place and the vector from the other box to it. A corner's number has a bit for each axis.
        private var _corners:Vector.<Number> = new Vector.<Number>(24, true);
        private var _gaps:Vector.<Number> = new Vector.<Number>(24, true);

        /** Finds the point of a's edges that is nearest to b. */
        public function findNearest(a:Box, b:Box):void
        {
            halfX = b.halfX;
            halfY = b.halfY;
            halfZ = b.halfZ;
            rotateHalf(a.axisX, a.halfX, b, 0);
            rotateHalf(a.axisY, a.halfY, b, 3);
            rotateHalf(a.axisZ, a.halfZ, b, 6);
            squared = Infinity;
            findCorners(a.center, b);
            for (var i:int = 0; i < 36 && squared > 0; i += 3)
            {
                tryEdge(EDGES[i], EDGES[int(i + 1)], EDGES[int(i + 2)]);
            }
        }

        /**
         * Whether no other point of the box is nearer. This is so if the whole box is beyond one plane: the plane through the point,
         * perpendicular to the line between the closest points.
         */
        public function isLeast():Boolean
        {
            var x:Number = _fromOtherX;
            var y:Number = _fromOtherY;
            var z:Number = _fromOtherZ;
            var halves:Vector.<Number> = _halves;
            var reachX:Number = x * halves[0] + y * halves[1] + z * halves[2];
            var reachY:Number = x * halves[3] + y * halves[4] + z * halves[5];
            var reachZ:Number = x * halves[6] + y * halves[7] + z * halves[8];
            reachX = reachX < 0 ? -reachX : reachX;
            reachY = reachY < 0 ? -reachY : reachY;
            reachZ = reachZ < 0 ? -reachZ : reachZ;
            var reach:Number = reachX + reachY + reachZ;
            // How far the middle is from the point along the line. This is at most reach.
            var along:Number = x * (_middleX - _pointX) + y * (_middleY - _pointY) + z * (_middleZ - _pointZ);
            return reach - along <= NEARER * (reach + squared);
        }

        /**
         * Writes the closest points.
         *
         * @param b the other box
         * @param isSwapped whether the other box is the first of the pair
         * @param out receives the points
         */
        public function write(b:Box, isSwapped:Boolean, out:DistanceResult):void
        {
            gapX = _pointX;
            gapY = _pointY;
            gapZ = _pointZ;
            rotateGap(b);
            out.aX = b.center.x + gapX;
            out.aY = b.center.y + gapY;
            out.aZ = b.center.z + gapZ;
            gapX = _fromOtherX;
            gapY = _fromOtherY;
            gapZ = _fromOtherZ;
            rotateGap(b);
            out.gapX = gapX;
            out.gapY = gapY;
            out.gapZ = gapZ;
            out.radiusA = out.radiusB = 0;
            out.separate();
            if (isSwapped)
            {
                out.swapShapes();
            }
        }

        // Writes half of a's edges along an axis, in b's axes.
        private function rotateHalf(axis:Vector3D, half:Number, b:Box, at:int):void
        {
            var to:Vector3D = b.axisX;
            _halves[at] = half * (axis.x * to.x + axis.y * to.y + axis.z * to.z);
            to = b.axisY;
            _halves[int(at + 1)] = half * (axis.x * to.x + axis.y * to.y + axis.z * to.z);
            to = b.axisZ;
            _halves[int(at + 2)] = half * (axis.x * to.x + axis.y * to.y + axis.z * to.z);
        }

        private function findCorners(middle:Vector3D, b:Box):void
        {
            var toX:Number = middle.x - b.center.x;
            var toY:Number = middle.y - b.center.y;
            var toZ:Number = middle.z - b.center.z;
            var halves:Vector.<Number> = _halves;
            var axis:Vector3D = b.axisX;
            var middleX:Number = axis.x * toX + axis.y * toY + axis.z * toZ;
            axis = b.axisY;
            var middleY:Number = axis.x * toX + axis.y * toY + axis.z * toZ;
            axis = b.axisZ;
            var middleZ:Number = axis.x * toX + axis.y * toY + axis.z * toZ;
            _middleX = middleX;
            _middleY = middleY;
            _middleZ = middleZ;
            for (var corner:int = 0; corner < 8; corner++)
            {
                var signX:int = ((corner & 1) << 1) - 1;
                var signY:int = (corner & 2) - 1;
                var signZ:int = ((corner & 4) >> 1) - 1;
                var x:Number = signX * halves[0] + signY * halves[3] + signZ * halves[6] + middleX;
                var y:Number = signX * halves[1] + signY * halves[4] + signZ * halves[7] + middleY;
                var z:Number = signX * halves[2] + signY * halves[5] + signZ * halves[8] + middleZ;
                var at:int = 3 * corner;
                _corners[at] = x;
                _corners[int(at + 1)] = y;
                _corners[int(at + 2)] = z;
                var half:Number = halfX;
                var outX:Number = x > half ? x - half : (x < -half ? x + half : 0);
                half = halfY;
                var outY:Number = y > half ? y - half : (y < -half ? y + half : 0);
                half = halfZ;
                var outZ:Number = z > half ? z - half : (z < -half ? z + half : 0);
                _gaps[at] = outX;
                _gaps[int(at + 1)] = outY;
                _gaps[int(at + 2)] = outZ;
                var length:Number = outX * outX + outY * outY + outZ * outZ;
                if (length < squared)
                {
                    squared = length;
                    _pointX = x;
                    _pointY = y;
                    _pointZ = z;
                    _fromOtherX = outX;
                    _fromOtherY = outY;
                    _fromOtherZ = outZ;
                }
            }
        }

        // Looks between the ends of an edge if the distance gets smaller from both.
        private function tryEdge(half:int, start:int, end:int):void
        {
            var gaps:Vector.<Number> = _gaps;
            var x:Number = 2 * _halves[half];
            var y:Number = 2 * _halves[int(half + 1)];
            var z:Number = 2 * _halves[int(half + 2)];
            if (!(x * gaps[start] + y * gaps[int(start + 1)] + z * gaps[int(start + 2)] < 0))
            {
                return;
            }
            if (!(x * gaps[end] + y * gaps[int(end + 1)] + z * gaps[int(end + 2)] > 0))
            {
                return;
            }
            var signX:int = x < 0 ? -1 : 1;
            var signY:int = y < 0 ? -1 : 1;
            var signZ:int = z < 0 ? -1 : 1;
            alongX = signX * x;
            alongY = signY * y;
            alongZ = signZ * z;
            fromX = signX * _corners[start];
            fromY = signY * _corners[int(start + 1)];
            fromZ = signZ * _corners[int(start + 2)];
            motionX = motionY = motionZ = 0;
            timeParameter = 0;
            find();
            var length:Number = gapX * gapX + gapY * gapY + gapZ * gapZ;
            if (length < squared)
            {
                squared = length;
                _pointX = _corners[start] + share * x;
                _pointY = _corners[int(start + 1)] + share * y;
                _pointZ = _corners[int(start + 2)] + share * z;
                _fromOtherX = signX * gapX;
                _fromOtherY = signY * gapY;
                _fromOtherZ = signZ * gapZ;
            }
        }
    }
}
