package starlogo.bounding
{
    import flash.geom.Matrix3D;
    import flash.geom.Vector3D;
    import starlogo.convex.ConvexShape;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.geometry.Tolerances;
    import starlogo.geometry.hull.ConvexHull;
    import starlogo.geometry.scaleAndRotatePoints;
    import starlogo.geometry.vertices.VertexBounds;
    import starlogo.geometry.vertices.vertexProblem;

    use namespace engine;

    /**
     * The convex hull of points: the smallest convex solid that contains them. The hull of points in a plane is a polygon, the hull of
     * points on a line is a segment, and the hull of points in one place is a point.
     *
     * <p>A test with a hull costs more than a test with a box, and more with each corner. A HullFitter finds hulls of few corners for
     * models.</p>
     */
    public final class Hull extends BoundingStructure
    {
        private static const POINT:Vector.<Number> = new <Number>[0, 0, 0];

        private static var sRotated:Vector.<Number> = new Vector.<Number>();
        private static var sBounds:VertexBounds = new VertexBounds();

        // Structures may be larger than what ConvexHull takes. So it gets the corners divided by this number: 2^40, which loses no
        // digits.
        private static const HULL_SCALE:Number = 1099511627776;

        /** A point inside of the hull: the mean of the points of which it was made. */
        public var center:Vector3D = new Vector3D();

        /**
         * The corners relative to the centre, x, y, z of each.
         *
         * @private
         */
        engine var relativeCorners:Vector.<Number> = new Vector.<Number>();

        /**
         * Which corners make the faces and edges.
         *
         * @private
         */
        engine var topology:HullTopology = null;

        /**
         * The radius around the hull of the corners: points up to this distance from it belong to this hull. It is as small as a rounding error.
         *
         * @private
         */
        engine var radius:Number = 0;

        // Empty until they are needed.
        private var _halfSpaces:Vector.<Number> = new Vector.<Number>();

        // The bounding radius of a shape of these corners; -1 until it is needed. So a body's hull finds it once, not once for each pair.
        private var _boundingRadius:Number = -1;

        /**
         * Creates the hull of points. The cost is n log n for n points.
         *
         * @param points x, y, z of each, in patches; neither kept nor changed. A point that is outside of the hull of the others by less
         *     than 2e-7 of the points' extent, or by a rounding error of its place, may be left out
         * @throws ArgumentError if the points are null or empty, if the number of coordinates is not a multiple of 3, or if a coordinate is
         *     not finite
         * @throws RangeError if the hull is beyond the limits of structures
         */
        public function Hull(points:Vector.<Number>)
        {
            super(HULL);
            var problem:String = vertexProblem(points);
            if (problem != null)
            {
                throw new ArgumentError(problem);
            }
            var count:int = points.length / 3;
            for (var i:int = 0; i < points.length; i += 3)
            {
                center.x += points[i] / count;
                center.y += points[i + 1] / count;
                center.z += points[i + 2] / count;
            }
            var relative:Vector.<Number> = new Vector.<Number>(points.length);
            for (i = 0; i < points.length; i += 3)
            {
                relative[i] = points[i] - center.x;
                relative[i + 1] = points[i + 1] - center.y;
                relative[i + 2] = points[i + 2] - center.z;
            }
            check(relative);
            setCorners(relative);
        }

        /** @inheritDoc */
        override public function toString():String
        {
            return "a Hull of " + relativeCorners.length / 3 + " corners around " + center;
        }

        /** The corners, x, y, z of each, in a list of their own. The surface may be outside of them by a rounding error. */
        public function get corners():Vector.<Number>
        {
            var result:Vector.<Number> = new Vector.<Number>(relativeCorners.length);
            for (var i:int = 0; i < relativeCorners.length; i += 3)
            {
                result[i] = center.x + relativeCorners[i];
                result[i + 1] = center.y + relativeCorners[i + 1];
                result[i + 2] = center.z + relativeCorners[i + 2];
            }
            return result;
        }

        /**
         * The triangles of the surface, in a list of their own: three corners each, counter-clockwise seen from outside. The first corner
         * has the number 0. A flat hull has the triangles of its front and of its back. A segment and a point have none.
         */
        public function get faces():Vector.<int>
        {
            var result:Vector.<int> = new Vector.<int>(topology.faces.length);
            for (var i:int = 0; i < result.length; i++)
            {
                result[i] = topology.faces[i] / 3;
            }
            return result;
        }

        /** @inheritDoc */
        override public function get volume():Number
        {
            return topology.dimension == 3 ? ConvexHull.volumeInside(relativeCorners, faces) : 0;
        }

        /** @inheritDoc */
        override public function rotate(rotation:Matrix3D):BoundingStructure
        {
            super.rotate(rotation);
            if (rotation.determinant < 0)
            {
                setCorners(relativeCorners);
            }
            return this;
        }

        /** @inheritDoc */
        override public function contains(point:Vector3D):Boolean
        {
            var x:Number = point.x - center.x;
            var y:Number = point.y - center.y;
            var z:Number = point.z - center.z;
            var limit:Number = radius + slack(farthestCorner(relativeCorners), center);
            var planes:Vector.<Number> = halfSpaces;
            for (var i:int = 0; i < planes.length; i += 4)
            {
                // The comparison is false for NaN too.
                if (!(planes[i] * x + planes[i + 1] * y + planes[i + 2] * z <= planes[i + 3] + limit))
                {
                    return false;
                }
            }
            return !isBeyondEdge(x, y, z, limit);
        }

        /** @inheritDoc */
        override public function clone():BoundingStructure
        {
            check(relativeCorners);
            checkLength(radius, "the radius around a hull's corners");
            return place(Placement.IDENTITY, new Hull(POINT));
        }

        /** @inheritDoc */
        override public function place(placement:Placement, out:BoundingStructure = null):BoundingStructure
        {
            var placed:Hull = out as Hull || newFor(out) as Hull;
            if (placed.relativeCorners.length != relativeCorners.length)
            {
                placed.relativeCorners.length = relativeCorners.length;
            }
            scaleAndRotatePoints(placement, relativeCorners, placed.relativeCorners);
            placement.place(center, placed.center);
            placed.radius = radius * placement.size;
            placed.topology = topology;
            placed.forgetShape();
            return placed;
        }

        /**
         * @inheritDoc
         *
         * Their intersection is the hull of the corners, without the radius. Those whose planes go through the centre come first. A flat hull
         * has two of them, a segment four, and a point six. The list is kept until the hull changes.
         *
         * @private
         */
        override engine function get halfSpaces():Vector.<Number>
        {
            if (_halfSpaces.length == 0)
            {
                HalfSpaces.find(relativeCorners, topology, _halfSpaces);
            }
            return _halfSpaces;
        }

        /**
         * @inheritDoc
         *
         * @private
         */
        override engine function widen(by:Number):void
        {
            radius += by;
        }

        /** @private */
        override engine function widenForSurfaces():void
        {
            // The tolerance depends on the model's radius about the middle of its extents. That radius is at most the square root of 3 times
            // the radius about any other point.
            widen(4 * Tolerances.SURFACES * farthestCorner(relativeCorners));
        }

        /** @private */
        override engine function findPlacedBox(placement:Placement, out:Vector.<Number>):void
        {
            var rotated:Vector.<Number> = sRotated;
            var bounds:VertexBounds = sBounds;
            scaleAndRotatePoints(placement, relativeCorners, rotated);
            bounds.clear();
            bounds.add(rotated, 0, relativeCorners.length / 3);
            var size:Number = placement.size;
            var x:Number = center.x * size;
            var y:Number = center.y * size;
            var z:Number = center.z * size;
            var margin:Number = radius * size + Tolerances.ROUNDING * (bounds.maxX - bounds.minX + (bounds.maxY - bounds.minY)
                    + (bounds.maxZ - bounds.minZ) + Math.abs(x) + Math.abs(y) + Math.abs(z));
            out[0] = placement.r00 * x + placement.r01 * y + placement.r02 * z + (bounds.minX + bounds.maxX) / 2;
            out[1] = placement.r10 * x + placement.r11 * y + placement.r12 * z + (bounds.minY + bounds.maxY) / 2;
            out[2] = placement.r20 * x + placement.r21 * y + placement.r22 * z + (bounds.minZ + bounds.maxZ) / 2;
            out[3] = (bounds.maxX - bounds.minX) / 2 + margin;
            out[4] = (bounds.maxY - bounds.minY) / 2 + margin;
            out[5] = (bounds.maxZ - bounds.minZ) / 2 + margin;
        }

        /** @private */
        override engine function setShape(out:ConvexShape):void
        {
            out.setHull(center, relativeCorners, topology.faces, topology.edges, _boundingRadius);
            _boundingRadius = out.boundingRadius;
            out.radius = radius;
        }

        /** @private The centre, the radius, then the corners relative to the centre. */
        override engine function toNumbers():Vector.<Number>
        {
            return new <Number>[center.x, center.y, center.z, radius].concat(relativeCorners);
        }

        /**
         * @private
         * @throws ArgumentError if the numbers of the corners are none, or not a multiple of 3, or not finite
         */
        override engine function setFromNumbers(numbers:Vector.<Number>):void
        {
            center.setTo(numbers[0], numbers[1], numbers[2]);
            radius = numbers[3];
            setCorners(numbers.slice(4));
        }

        /** @private Scales the corners about the centre. The radius stays. */
        engine function scaleCorners(factor:Number):void
        {
            setCorners(scaled(relativeCorners, factor));
        }

        // Whether a point, relative to the centre, is farther from the hull of the corners than a limit, though no plane of a face says so: beyond a sharp
        // edge or corner. The hull's nearest point is then on the nearest edge, and all corners are behind it.
        private function isBeyondEdge(pointX:Number, pointY:Number, pointZ:Number, limit:Number):Boolean
        {
            var points:Vector.<Number> = relativeCorners;
            var edges:Vector.<int> = topology.edges;
            // a point has no edge
            var gapX:Number = pointX - points[0];
            var gapY:Number = pointY - points[1];
            var gapZ:Number = pointZ - points[2];
            var least:Number = gapX * gapX + gapY * gapY + gapZ * gapZ;
            for (var i:int = 0; i < edges.length; i += 4)
            {
                var start:int = edges[i];
                var end:int = edges[i + 1];
                var axisX:Number = points[end] - points[start];
                var axisY:Number = points[end + 1] - points[start + 1];
                var axisZ:Number = points[end + 2] - points[start + 2];
                var x:Number = pointX - points[start];
                var y:Number = pointY - points[start + 1];
                var z:Number = pointZ - points[start + 2];
                include "../geometry/pointToSegment.inc";
                var squared:Number = x * x + y * y + z * z;
                if (squared < least)
                {
                    least = squared;
                    gapX = x;
                    gapY = y;
                    gapZ = z;
                }
            }
            var reach:Number = limit * Math.sqrt(least);
            for (i = 0; i < points.length; i += 3)
            {
                if (gapX * (pointX - points[i]) + gapY * (pointY - points[i + 1]) + gapZ * (pointZ - points[i + 2]) <= reach)
                {
                    return false;
                }
            }
            return true;
        }

        // Checks the centre and corners relative to it.
        private function check(corners:Vector.<Number>):void
        {
            checkVector(center, "the centre of a hull");
            checkLength(farthestCorner(corners), "the distance of a hull's corners from its centre");
            checkSize(VertexBounds.of(corners).extent, "a hull");
        }

        // The largest distance of a corner from the centre.
        private static function farthestCorner(corners:Vector.<Number>):Number
        {
            var most:Number = 0;
            for (var i:int = 0; i < corners.length; i += 3)
            {
                var square:Number = corners[i] * corners[i] + corners[i + 1] * corners[i + 1] + corners[i + 2] * corners[i + 2];
                most = square > most ? square : most;
            }
            return Math.sqrt(most);
        }

        private static function scaled(corners:Vector.<Number>, factor:Number):Vector.<Number>
        {
            var result:Vector.<Number> = new Vector.<Number>(corners.length);
            for (var i:int = 0; i < corners.length; i++)
            {
                result[i] = corners[i] * factor;
            }
            return result;
        }

        // Sets the corners, and finds the faces and the edges, after the centre and the radius have been set. Corners that a ConvexHull drops are
        // dropped until it keeps all. So a hull of the corners of another one is the same hull.
        private function setCorners(corners:Vector.<Number>):void
        {
            var origin:Number = Math.max(Math.max(Math.abs(center.x), Math.abs(center.y)), Math.abs(center.z)) / HULL_SCALE;
            var hull:ConvexHull = new ConvexHull(scaled(corners, 1 / HULL_SCALE), true, origin);
            while (hull.points.length < hull.vertices.length)
            {
                hull = new ConvexHull(hull.points, true, origin);
            }
            relativeCorners = scaled(hull.points, HULL_SCALE);
            topology = HullTopology.of(hull);
            forgetShape();
        }

        // Forgets what was found of the corners, after they have changed.
        private function forgetShape():void
        {
            _boundingRadius = -1;
            if (_halfSpaces.length > 0)
            {
                _halfSpaces.length = 0;
            }
        }
    }
}
