package starlogo.intersection
{
    import flash.geom.Vector3D;
    import starlogo.bounding.Box;
    import starlogo.intersection.distance.ClosestPair;

    /**
     * The point of the edges of one box that is nearest to another box, in the axes of the other: at a corner, unless the distance to the other
     * box falls from both ends of an edge; then it is convex along the edge, and has its least in between.
     *
     * <p>Of two boxes that are apart the closest points can be chosen so that one of them is on an edge: points in the midst of two faces can be
     * moved along both until one leaves its face. Of boxes that overlap, an edge of one reaches into the other, or all of one is in it.</p>
     */
    internal final class BoxEdges extends SegmentBox
    {
        /** The square of the least distance. */
        public var squared:Number;

        // The point of the edges, from the other box's middle, and from the other's closest point to it.
        private var _pointX:Number;
        private var _pointY:Number;
        private var _pointZ:Number;
        private var _fromOtherX:Number;
        private var _fromOtherY:Number;
        private var _fromOtherZ:Number;

        // Half of each edge's length along the other's axes, x, y, z: those along axisX, axisY, axisZ.
        private var _halves:Vector.<Number> = new Vector.<Number>(9, true);

        // By corner, whose number has a bit for each axis: where it is, and from the other box to it.
        private var _corners:Vector.<Number> = new Vector.<Number>(24, true);
        private var _gaps:Vector.<Number> = new Vector.<Number>(24, true);

        /** Nothing found yet. */
        public function BoxEdges()
        {
        }

        /** Finds the point of a's edges that is nearest to b. */
        public function findNearest(a:Box, b:Box):void
        {
            halfX = b.halfX;
            halfY = b.halfY;
            halfZ = b.halfZ;
            turnHalf(a.axisX, b, 0);
            turnHalf(a.axisY, b, 3);
            turnHalf(a.axisZ, b, 6);
            scaleHalves(a);
            squared = Infinity;
            findCorners(a.center, b);
            for (var axis:int = 0; axis < 3; axis++)
            {
                var bit:int = 1 << axis;
                for (var corner:int = 0; corner < 8; corner++)
                {
                    if ((corner & bit) == 0 && squared > 0)
                    {
                        tryEdge(3 * axis, 3 * corner, 3 * (corner | bit));
                    }
                }
            }
        }

        /**
         * Writes the closest points.
         *
         * @param b the other box
         * @param isTurned whether the other box is the first of the pair
         * @param out takes them
         */
        public function write(b:Box, isTurned:Boolean, out:ClosestPair):void
        {
            gapX = _pointX;
            gapY = _pointY;
            gapZ = _pointZ;
            turnGap(b);
            out.aX = b.center.x + gapX;
            out.aY = b.center.y + gapY;
            out.aZ = b.center.z + gapZ;
            gapX = _fromOtherX;
            gapY = _fromOtherY;
            gapZ = _fromOtherZ;
            turnGap(b);
            out.gapX = gapX;
            out.gapY = gapY;
            out.gapZ = gapZ;
            out.radiusA = out.radiusB = 0;
            out.separate();
            if (isTurned)
            {
                out.turn();
            }
        }

        // An axis of a in b's axes.
        private function turnHalf(axis:Vector3D, b:Box, at:int):void
        {
            var to:Vector3D = b.axisX;
            _halves[at] = axis.x * to.x + axis.y * to.y + axis.z * to.z;
            to = b.axisY;
            _halves[int(at + 1)] = axis.x * to.x + axis.y * to.y + axis.z * to.z;
            to = b.axisZ;
            _halves[int(at + 2)] = axis.x * to.x + axis.y * to.y + axis.z * to.z;
        }

        private function scaleHalves(a:Box):void
        {
            for (var i:int = 0; i < 3; i++)
            {
                _halves[i] *= a.halfX;
                _halves[int(i + 3)] *= a.halfY;
                _halves[int(i + 6)] *= a.halfZ;
            }
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

        // Looks in between the ends of an edge if the distance falls from both.
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
            find(0);
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
