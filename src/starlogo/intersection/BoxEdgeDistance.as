package starlogo.intersection
{
    import flash.geom.Vector3D;
    import starlogo.bounding.Box;
    import starlogo.intersection.distance.RoundGap;
    import starlogo.intersection.distance.DistanceResult;
    import starlogo.intersection.distance.moveToSurfaces;

    /**
     * Finds the point on the edges of one box that is nearest to another box, in the other box's axes. The point is a corner, unless the
     * distance gets smaller from both ends of an edge. In that case the distance is convex along the edge, and its minimum lies between the
     * ends.
     *
     * <p>If two boxes are apart, their closest points can be chosen so that one of them is on an edge: two points inside of faces can be
     * moved together until one reaches the rim of its face. If two boxes overlap, an edge of one reaches into the other, or one box is
     * inside of the other.</p>
     */
    internal final class BoxEdgeDistance
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

        // From the other box's middle to the box's middle, in the space of both.
        private var _middle:Vector3D = new Vector3D();

        // The point on the edges, as seen from the other box's middle, and as seen from the other box's closest point.
        private var _pointX:Number;
        private var _pointY:Number;
        private var _pointZ:Number;
        private var _fromOtherX:Number;
        private var _fromOtherY:Number;
        private var _fromOtherZ:Number;

        // The edge that is tried, in the other box's axes, and its gap.
        private var _edge:BoxSegment = new BoxSegment();
        private var _gap:RoundGap = new RoundGap();

        // In the other box's axes: half of the edges along axisX, then axisY, then axisZ, and the box's middle.
        private var _halves:Vector.<Number> = new Vector.<Number>(12, true);

        // For each corner, its place and the vector from the other box to it. A corner's number has a bit for each axis.
        private var _corners:Vector.<Number> = new Vector.<Number>(24, true);
        private var _gaps:Vector.<Number> = new Vector.<Number>(24, true);

        /** Finds the point of a's edges that is nearest to b. */
        public function findNearest(a:Box, b:Box):void
        {
            _edge.halfX = b.halfX;
            _edge.halfY = b.halfY;
            _edge.halfZ = b.halfZ;
            rotateInto(a.axisX, a.halfX, b, 0);
            rotateInto(a.axisY, a.halfY, b, 3);
            rotateInto(a.axisZ, a.halfZ, b, 6);
            _middle.x = a.center.x - b.center.x;
            _middle.y = a.center.y - b.center.y;
            _middle.z = a.center.z - b.center.z;
            rotateInto(_middle, 1, b, 9);
            squared = Infinity;
            findCorners();
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
            var along:Number = x * (halves[9] - _pointX) + y * (halves[10] - _pointY) + z * (halves[11] - _pointZ);
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
            _gap.x = _pointX;
            _gap.y = _pointY;
            _gap.z = _pointZ;
            rotateFromBox(b, _gap);
            out.aX = b.center.x + _gap.x;
            out.aY = b.center.y + _gap.y;
            out.aZ = b.center.z + _gap.z;
            _gap.x = _fromOtherX;
            _gap.y = _fromOtherY;
            _gap.z = _fromOtherZ;
            rotateFromBox(b, _gap);
            moveToSurfaces(_gap, out);
            if (isSwapped)
            {
                out.swapShapes();
            }
        }

        // Writes a multiple of a vector in b's axes.
        private function rotateInto(vector:Vector3D, factor:Number, b:Box, at:int):void
        {
            var to:Vector3D = b.axisX;
            _halves[at] = factor * (vector.x * to.x + vector.y * to.y + vector.z * to.z);
            to = b.axisY;
            _halves[int(at + 1)] = factor * (vector.x * to.x + vector.y * to.y + vector.z * to.z);
            to = b.axisZ;
            _halves[int(at + 2)] = factor * (vector.x * to.x + vector.y * to.y + vector.z * to.z);
        }

        private function findCorners():void
        {
            var halfX:Number = _edge.halfX;
            var halfY:Number = _edge.halfY;
            var halfZ:Number = _edge.halfZ;
            var halves:Vector.<Number> = _halves;
            var corners:Vector.<Number> = _corners;
            for (var corner:int = 0; corner < 8; corner++)
            {
                var signX:int = ((corner & 1) << 1) - 1;
                var signY:int = (corner & 2) - 1;
                var signZ:int = ((corner & 4) >> 1) - 1;
                var x:Number = signX * halves[0] + signY * halves[3] + signZ * halves[6] + halves[9];
                var y:Number = signX * halves[1] + signY * halves[4] + signZ * halves[7] + halves[10];
                var z:Number = signX * halves[2] + signY * halves[5] + signZ * halves[8] + halves[11];
                var at:int = 3 * corner;
                corners[at] = x;
                corners[int(at + 1)] = y;
                corners[int(at + 2)] = z;
                include "pointToBox.inc";
                var length:Number = x * x + y * y + z * z;
                _gaps[at] = x;
                _gaps[int(at + 1)] = y;
                _gaps[int(at + 2)] = z;
                if (length < squared)
                {
                    squared = length;
                    _pointX = corners[at];
                    _pointY = corners[int(at + 1)];
                    _pointZ = corners[int(at + 2)];
                    _fromOtherX = x;
                    _fromOtherY = y;
                    _fromOtherZ = z;
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
            _edge.alongX = signX * x;
            _edge.alongY = signY * y;
            _edge.alongZ = signZ * z;
            _edge.x = signX * _corners[start];
            _edge.y = signY * _corners[int(start + 1)];
            _edge.z = signZ * _corners[int(start + 2)];
            findBoxSegmentGap(_edge, _gap);
            var length:Number = _gap.x * _gap.x + _gap.y * _gap.y + _gap.z * _gap.z;
            if (length < squared)
            {
                squared = length;
                _pointX = _corners[start] + _gap.share * x;
                _pointY = _corners[int(start + 1)] + _gap.share * y;
                _pointZ = _corners[int(start + 2)] + _gap.share * z;
                _fromOtherX = signX * _gap.x;
                _fromOtherY = signY * _gap.y;
                _fromOtherZ = signZ * _gap.z;
            }
        }
    }
}
