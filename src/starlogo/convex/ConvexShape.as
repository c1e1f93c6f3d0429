package starlogo.convex
{
    import flash.geom.Vector3D;
    import starlogo.geometry.Tolerances;

    /**
     * A convex shape where it stands: a core and a radius around it (a rounded hull). The core is the convex hull of points: one for a sphere, two for a
     * capsule, three for a triangle, eight for a box. Any number of points is a hull. A shape is set once for a body, and then takes part in any
     * number of questions. A structure sets it by <code>BoundingStructure.setShape()</code>. Its fields are read only, except for the radius and the
     * margin: these may be set after the core.
     *
     * <p>The points are relative to an origin near them, so nothing is lost far from the origin of the world.</p>
     *
     * @private
     */
    public final class ConvexShape
    {
        /** What a core is: see <code>coreKind</code>. A hull may have as few points as the others. */
        public static const POINT:int = 0;
        public static const SEGMENT:int = 1;
        public static const TRIANGLE:int = 2;
        public static const BOX:int = 3;
        public static const HULL:int = 4;

        // A list for shapes without faces, or without edges.
        private static const NONE:Vector.<int> = new Vector.<int>(0);

        private static const SEGMENT_EDGES:Vector.<int> = new <int>[0, 3, 0, 0];
        private static const TRIANGLE_FACES:Vector.<int> = new <int>[0, 3, 6];
        private static const TRIANGLE_EDGES:Vector.<int> = new <int>[0, 3, 0, 0, 3, 6, 3, 3, 6, 0, 6, 6];

        // The points of a box are numbered by bits: 1 if a point is on the high side along axisX, 2 along axisY, 4 along axisZ. These are the numbers times
        // 3, because each point has three coordinates.
        private static const BOX_FACES:Vector.<int> = new <int>[0, 3, 6, 0, 6, 12, 0, 12, 3];
        private static const BOX_EDGES:Vector.<int> = new <int>[0, 3, 0, 0, 0, 6, 0, 0, 0, 12, 0, 0];

        /** What the core is: POINT, SEGMENT, TRIANGLE, BOX or HULL. */
        public var coreKind:int = POINT;

        /** The origin of the points. */
        public var origin:Vector3D = new Vector3D();

        /** The radius around the core. A new core has none. */
        public var radius:Number = 0;

        /**
         * How far beyond its surface other shapes still touch it, because its place or its surface is rounded (see Touching). Distances do not
         * include it. A new core has none, except for a hull.
         */
        public var margin:Number = 0;

        /**
         * The radius of a ball around the origin that contains the core. Rounding is relative to it. It is twice the largest coordinate of a point,
         * or twice the sum of a box's half-extents; 0 for a sphere.
         */
        public var boundingRadius:Number = 0;

        /** The points: x, y, z of each. The list may be longer than <code>pointsEnd</code>, the count of these numbers. */
        public var points:Vector.<Number>;
        public var pointsEnd:int = 0;

        /** Three points of each of the core's faces, as indices of their first numbers. A box has three faces: one for each axis. */
        public var faces:Vector.<int> = NONE;

        /**
         * The core's edges, as four indices each: both ends, and one more point of each of the two faces beside the edge if
         * <code>hasFacesAtEdges</code>. If not, the start stands in place of both points. A box has three of its twelve edges, those at its first
         * point, because the others are parallel to them.
         */
        public var edges:Vector.<int> = NONE;

        /** Whether the edges say which faces are beside them. Only those of a hull do. */
        public function get hasFacesAtEdges():Boolean
        {
            return coreKind == HULL;
        }

        /** Whether the core is a box or a segment. Then its edges are perpendicular to each other, from the first point on. */
        public function get areEdgesPerpendicular():Boolean
        {
            return coreKind == BOX || coreKind == SEGMENT;
        }

        // The list of points for all shapes but hulls.
        private var _ownPoints:Vector.<Number> = new Vector.<Number>(24, true);

        public function ConvexShape()
        {
            points = _ownPoints;
        }

        /** Sets the core to a point. */
        public function setPoint(at:Vector3D):void
        {
            origin.copyFrom(at);
            reset(POINT, 3, NONE, NONE);
            points[0] = points[1] = points[2] = 0;
            boundingRadius = 0;
        }

        /** Sets the core to a segment. */
        public function setSegment(start:Vector3D, end:Vector3D):void
        {
            origin.copyFrom(start);
            reset(SEGMENT, 6, NONE, SEGMENT_EDGES);
            points[0] = points[1] = points[2] = 0;
            points[3] = end.x - start.x;
            points[4] = end.y - start.y;
            points[5] = end.z - start.z;
            setBoundingRadius();
        }

        /**
         * Sets the core to a box.
         *
         * @param axisX a unit vector, as axisY and axisZ are. They are perpendicular
         * @param halves the half-extents along the axes
         */
        public function setBox(center:Vector3D, axisX:Vector3D, axisY:Vector3D, axisZ:Vector3D, halves:Vector3D):void
        {
            origin.copyFrom(center);
            reset(BOX, 24, BOX_FACES, BOX_EDGES);
            boundingRadius = 2 * (halves.x + halves.y + halves.z);
            writeCorners(0, halves.x * axisX.x, halves.y * axisY.x, halves.z * axisZ.x);
            writeCorners(1, halves.x * axisX.y, halves.y * axisY.y, halves.z * axisZ.y);
            writeCorners(2, halves.x * axisX.z, halves.y * axisY.z, halves.z * axisZ.z);
        }

        /** Sets the core to a triangle: nine numbers of a list, from an index on. */
        public function setTriangle(corners:Vector.<Number>, at:int):void
        {
            var x:Number = corners[at];
            var y:Number = corners[int(at + 1)];
            var z:Number = corners[int(at + 2)];
            origin.x = x;
            origin.y = y;
            origin.z = z;
            reset(TRIANGLE, 9, TRIANGLE_FACES, TRIANGLE_EDGES);
            var p:Vector.<Number> = points;
            p[0] = p[1] = p[2] = 0;
            p[3] = corners[int(at + 3)] - x;
            p[4] = corners[int(at + 4)] - y;
            p[5] = corners[int(at + 5)] - z;
            p[6] = corners[int(at + 6)] - x;
            p[7] = corners[int(at + 7)] - y;
            p[8] = corners[int(at + 8)] - z;
            setBoundingRadius();
        }

        /**
         * Sets the core to a hull: points relative to a center, which may be in one plane, on a line or in one place. The lists are kept, not copied, so a
         * hull that moves has to be set again.
         *
         * @param faces three points of each face, counter-clockwise as seen from outside, as indices of their first numbers
         * @param edges of each edge both ends, and one more point of each of its two faces
         * @param knownBoundingRadius that of the same points, from an earlier call; less than 0 if it is to be found, which takes long beside a test
         */
        public function setHull(center:Vector3D, points:Vector.<Number>, faces:Vector.<int>, edges:Vector.<int>, knownBoundingRadius:Number = -1):void
        {
            origin.copyFrom(center);
            reset(HULL, points.length, faces, edges);
            this.points = points;
            boundingRadius = knownBoundingRadius;
            if (knownBoundingRadius < 0)
            {
                setBoundingRadius();
            }
            // the largest coordinate counts as a radius: see Touching
            margin = (Tolerances.TOUCHING - 1) * boundingRadius / 2;
        }

        /**
         * The support function of the core: returns the index of the first number of the point that is farthest along a direction, or against it if the
         * sign is -1.
         */
        public function support(direction:Vector3D, sign:int):int
        {
            var p:Vector.<Number> = points;
            var directionX:Number = sign * direction.x;
            var directionY:Number = sign * direction.y;
            var directionZ:Number = sign * direction.z;
            var best:int = 0;
            if (coreKind == BOX)
            {
                // the edges along the three axes decide one by one
                var firstX:Number = p[0];
                var firstY:Number = p[1];
                var firstZ:Number = p[2];
                if (directionX * (p[3] - firstX) + directionY * (p[4] - firstY) + directionZ * (p[5] - firstZ) > 0)
                {
                    best = 3;
                }
                if (directionX * (p[6] - firstX) + directionY * (p[7] - firstY) + directionZ * (p[8] - firstZ) > 0)
                {
                    best += 6;
                }
                if (directionX * (p[12] - firstX) + directionY * (p[13] - firstY) + directionZ * (p[14] - firstZ) > 0)
                {
                    best += 12;
                }
                return best;
            }
            var most:Number = directionX * p[0] + directionY * p[1] + directionZ * p[2];
            for (var i:int = 3; i < pointsEnd; i += 3)
            {
                var projection:Number = directionX * p[i] + directionY * p[int(i + 1)] + directionZ * p[int(i + 2)];
                if (projection > most)
                {
                    most = projection;
                    best = i;
                }
            }
            return best;
        }

        /** Finds how far the core extends along a direction of any length, relative to the origin and as a multiple of that length. */
        public function project(direction:Vector3D, out:Interval):void
        {
            var p:Vector.<Number> = points;
            var directionX:Number = direction.x;
            var directionY:Number = direction.y;
            var directionZ:Number = direction.z;
            var low:Number = directionX * p[0] + directionY * p[1] + directionZ * p[2];
            var high:Number = low;
            var projection:Number;
            if (coreKind == BOX)
            {
                // its origin is its middle, and each corner is opposite to one of these four
                projection = Math.abs(directionX * p[3] + directionY * p[4] + directionZ * p[5]);
                high = Math.abs(low);
                high = projection > high ? projection : high;
                projection = Math.abs(directionX * p[6] + directionY * p[7] + directionZ * p[8]);
                high = projection > high ? projection : high;
                projection = Math.abs(directionX * p[12] + directionY * p[13] + directionZ * p[14]);
                high = projection > high ? projection : high;
                low = -high;
            }
            else
            {
                for (var i:int = 3; i < pointsEnd; i += 3)
                {
                    projection = directionX * p[i] + directionY * p[int(i + 1)] + directionZ * p[int(i + 2)];
                    low = projection < low ? projection : low;
                    high = projection > high ? projection : high;
                }
            }
            out.min = low;
            out.max = high;
        }

        private function reset(coreKind:int, pointsEnd:int, faces:Vector.<int>, edges:Vector.<int>):void
        {
            this.coreKind = coreKind;
            points = _ownPoints;
            this.pointsEnd = pointsEnd;
            this.faces = faces;
            this.edges = edges;
            radius = margin = 0;
        }

        // Writes a coordinate of a box's corners: at 0 for x, 1 for y, 2 for z. Takes that of half an edge along each of the box's axes.
        private function writeCorners(at:int, alongX:Number, alongY:Number, alongZ:Number):void
        {
            var p:Vector.<Number> = points;
            p[int(at + 21)] = alongX + alongY + alongZ;
            p[int(at + 18)] = alongY + alongZ - alongX;
            p[int(at + 15)] = alongX + alongZ - alongY;
            p[int(at + 12)] = alongZ - alongX - alongY;
            p[int(at + 9)] = -p[int(at + 12)];
            p[int(at + 6)] = -p[int(at + 15)];
            p[int(at + 3)] = -p[int(at + 18)];
            p[at] = -p[int(at + 21)];
        }

        private function setBoundingRadius():void
        {
            var p:Vector.<Number> = points;
            var end:int = pointsEnd;
            var most:Number = 0;
            for (var i:int = 0; i < end; i++)
            {
                var coordinate:Number = p[i] < 0 ? -p[i] : p[i];
                most = coordinate > most ? coordinate : most;
            }
            boundingRadius = 2 * most;
        }
    }
}
