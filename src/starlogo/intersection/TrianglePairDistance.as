package starlogo.intersection
{
    import starlogo.geometry.Tolerances;
    import starlogo.intersection.distance.RoundGap;
    import starlogo.intersection.distance.DistanceResult;

    /**
     * Finds the closest points of two triangles, or of the closest pair among many. They are a corner of one and a point of the other's
     * face, or points of two edges, or the place where an edge of one passes through the other.
     *
     * <p>The result is exact except for rounding, which is 1e-15 of the triangles' size and of the distance. Needles have imprecise
     * normals, but their results are as exact: a point over a triangle is located along the triangle's longest edge first and then
     * perpendicular to it. A triangle that is no wider than rounding (Tolerances.FLAT_TRIANGLE) counts as its edges.</p>
     *
     * @private
     */
    public final class TrianglePairDistance
    {
        // How many numbers _over has for a corner.
        private static const PER_CORNER:int = 5;

        /** The largest distance at which areWithin returns true. */
        public var reach:Number = 0;

        /** The square of the smallest distance of the pairs since begin. */
        public var squared:Number = Infinity;

        /** The closest points of that pair. The distance in it is not set. */
        public var points:DistanceResult = new DistanceResult();

        private var _edges:SegmentPair = new SegmentPair();
        private var _gap:RoundGap = new RoundGap();

        // For each corner of one triangle, its place over the other triangle: the share of the longest edge, the share of the height, and
        // the vector from that place to the corner.
        private var _over:Vector.<Number> = new Vector.<Number>(3 * PER_CORNER, true);

        // A triangle's longest edge: the index of its start, and its vector. The triangle's height: its vector, and the share of the edge
        // at which it begins.
        private var _base:int;
        private var _u:Vector.<Number> = new Vector.<Number>(3, true);
        private var _h:Vector.<Number> = new Vector.<Number>(3, true);
        private var _foot:Number;

        /** Forgets all pairs. */
        public function begin():void
        {
            squared = Infinity;
        }

        /**
         * Adds a pair of triangles.
         *
         * @param a nine numbers of the first triangle: x, y, z of each corner
         * @param atA index of the first of them in a
         * @param b nine numbers of the second triangle, in the same space
         * @param atB index of the first of them in b
         */
        public function add(a:Vector.<Number>, atA:int, b:Vector.<Number>, atB:int):void
        {
            addFace(a, atA, b, atB, false);
            addFace(b, atB, a, atA, true);
            addEdges(a, atA, b, atB);
        }

        /**
         * Whether two triangles are no farther apart than <code>reach</code>. The parameters are the same as for add. Earlier pairs are
         * forgotten, and the points found are not always the closest ones.
         */
        public function areWithin(a:Vector.<Number>, atA:int, b:Vector.<Number>, atB:int):Boolean
        {
            var limit:Number = reach * reach;
            squared = Infinity;
            addFace(a, atA, b, atB, false);
            if (squared > limit)
            {
                addFace(b, atB, a, atA, true);
            }
            if (squared > limit)
            {
                addEdges(a, atA, b, atB);
            }
            return squared <= limit;
        }

        private function addEdges(a:Vector.<Number>, atA:int, b:Vector.<Number>, atB:int):void
        {
            var endA:int = atA + 6;
            for (var i:int = atA; i <= atA + 6; i += 3)
            {
                var endB:int = atB + 6;
                for (var k:int = atB; k <= atB + 6; k += 3)
                {
                    setEdges(a, endA, i, b, endB, k);
                    findSegmentGap(_edges, _gap);
                    var x:Number = _gap.x;
                    var y:Number = _gap.y;
                    var z:Number = _gap.z;
                    var length:Number = x * x + y * y + z * z;
                    if (length < squared)
                    {
                        squared = length;
                        var share:Number = _gap.share;
                        points.aX = a[endA] + share * (a[i] - a[endA]);
                        points.aY = a[int(endA + 1)] + share * (a[int(i + 1)] - a[int(endA + 1)]);
                        points.aZ = a[int(endA + 2)] + share * (a[int(i + 2)] - a[int(endA + 2)]);
                        points.bX = points.aX - x;
                        points.bY = points.aY - y;
                        points.bZ = points.aZ - z;
                    }
                    endB = k;
                }
                endA = i;
            }
        }

        private function setEdges(a:Vector.<Number>, startA:int, endA:int, b:Vector.<Number>, startB:int, endB:int):void
        {
            var edges:SegmentPair = _edges;
            edges.x = a[startA] - b[startB];
            edges.y = a[int(startA + 1)] - b[int(startB + 1)];
            edges.z = a[int(startA + 2)] - b[int(startB + 2)];
            edges.ux = a[endA] - a[startA];
            edges.uy = a[int(endA + 1)] - a[int(startA + 1)];
            edges.uz = a[int(endA + 2)] - a[int(startA + 2)];
            edges.vx = b[endB] - b[startB];
            edges.vy = b[int(endB + 1)] - b[int(startB + 1)];
            edges.vz = b[int(endB + 2)] - b[int(startB + 2)];
        }

        // Adds the corners of q over the face of p, and the edges of q that pass through the face.
        private function addFace(p:Vector.<Number>, atP:int, q:Vector.<Number>, atQ:int, isSwapped:Boolean):void
        {
            if (!findBase(p, atP))
            {
                return;
            }
            var over:Vector.<Number> = _over;
            for (var i:int = 0; i < 3; i++)
            {
                place(p, q, atQ + 3 * i, PER_CORNER * i);
            }
            for (i = 0; i < 3; i++)
            {
                var at:int = PER_CORNER * i;
                var gapX:Number = over[int(at + 2)];
                var gapY:Number = over[int(at + 3)];
                var gapZ:Number = over[int(at + 4)];
                var length:Number = gapX * gapX + gapY * gapY + gapZ * gapZ;
                var along:Number = over[at];
                var up:Number = over[int(at + 1)];
                var corner:int = atQ + 3 * i;
                if (length < squared && up >= 0 && up <= 1 && along >= _foot * up && along <= 1 - (1 - _foot) * up)
                {
                    squared = length;
                    points.aX = q[corner] - gapX;
                    points.aY = q[int(corner + 1)] - gapY;
                    points.aZ = q[int(corner + 2)] - gapZ;
                    points.bX = q[corner];
                    points.bY = q[int(corner + 1)];
                    points.bZ = q[int(corner + 2)];
                    if (isSwapped)
                    {
                        points.swapShapes();
                    }
                }

                // The edge to the next corner passes through the face if the next corner is on the other side.
                var next:int = i < 2 ? at + PER_CORNER : 0;
                if (gapX * over[int(next + 2)] + gapY * over[int(next + 3)] + gapZ * over[int(next + 4)] < 0)
                {
                    var beyond:Number = over[int(next + 2)] * over[int(next + 2)] + over[int(next + 3)] * over[int(next + 3)]
                        + over[int(next + 4)] * over[int(next + 4)];
                    beyond = Math.sqrt(beyond);
                    length = Math.sqrt(length);
                    var share:Number = length / (length + beyond);
                    along += share * (over[next] - along);
                    up += share * (over[int(next + 1)] - up);
                    if (up >= 0 && up <= 1 && along >= _foot * up && along <= 1 - (1 - _foot) * up)
                    {
                        squared = 0;
                        var end:int = i < 2 ? corner + 3 : atQ;
                        points.aX = points.bX = q[corner] + share * (q[end] - q[corner]);
                        points.aY = points.bY = q[int(corner + 1)] + share * (q[int(end + 1)] - q[int(corner + 1)]);
                        points.aZ = points.bZ = q[int(corner + 2)] + share * (q[int(end + 2)] - q[int(corner + 2)]);
                        return;
                    }
                }
            }
        }

        // Finds a triangle's longest edge and its height. Returns false if the height is 0.
        private function findBase(p:Vector.<Number>, at:int):Boolean
        {
            var longest:Number = -1;
            var apex:int = at;
            var start:int = at + 3;
            var end:int = at + 6;
            _base = at;
            for (var i:int = 0; i < 3; i++)
            {
                var ux:Number = p[end] - p[start];
                var uy:Number = p[int(end + 1)] - p[int(start + 1)];
                var uz:Number = p[int(end + 2)] - p[int(start + 2)];
                var uu:Number = ux * ux + uy * uy + uz * uz;
                if (uu > longest)
                {
                    longest = uu;
                    _base = start;
                    _u[0] = ux;
                    _u[1] = uy;
                    _u[2] = uz;
                    _h[0] = p[apex] - p[start];
                    _h[1] = p[int(apex + 1)] - p[int(start + 1)];
                    _h[2] = p[int(apex + 2)] - p[int(start + 2)];
                }
                var first:int = apex;
                apex = start;
                start = end;
                end = first;
            }
            _foot = (_u[0] * _h[0] + _u[1] * _h[1] + _u[2] * _h[2]) / longest;
            _h[0] -= _foot * _u[0];
            _h[1] -= _foot * _u[1];
            _h[2] -= _foot * _u[2];
            return _h[0] * _h[0] + _h[1] * _h[1] + _h[2] * _h[2] > Tolerances.FLAT_TRIANGLE * longest;
        }

        // Locates a corner of q over p.
        private function place(p:Vector.<Number>, q:Vector.<Number>, corner:int, to:int):void
        {
            var ux:Number = _u[0];
            var uy:Number = _u[1];
            var uz:Number = _u[2];
            var hx:Number = _h[0];
            var hy:Number = _h[1];
            var hz:Number = _h[2];
            var x:Number = q[corner] - p[_base];
            var y:Number = q[int(corner + 1)] - p[int(_base + 1)];
            var z:Number = q[int(corner + 2)] - p[int(_base + 2)];
            var along:Number = (x * ux + y * uy + z * uz) / (ux * ux + uy * uy + uz * uz);
            // The height is not quite perpendicular to the edge. In a needle, the part along the edge would hide the part along the height.
            x -= along * ux;
            y -= along * uy;
            z -= along * uz;
            var up:Number = (x * hx + y * hy + z * hz) / (hx * hx + hy * hy + hz * hz);
            _over[to] = along;
            _over[int(to + 1)] = up;
            _over[int(to + 2)] = x - up * hx;
            _over[int(to + 3)] = y - up * hy;
            _over[int(to + 4)] = z - up * hz;
        }
    }
}
