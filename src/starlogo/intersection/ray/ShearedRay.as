package starlogo.intersection.ray
{
    import flash.geom.Vector3D;
    import starlogo.convex.TrianglePlane;
    import starlogo.geometry.Tolerances;

    /**
     * A ray, prepared for many triangles. It finds where it meets a triangle, from either side (Woop, Benthin and Wald,
     * "Watertight Ray/Triangle Intersection", Journal of Computer Graphics Techniques 2(1), 2013, in double precision).
     *
     * <p>The corners are sheared so that the ray runs along an axis. Then the sign of one expression says on which side the ray passes an
     * edge. For the two triangles of an edge the two values are opposite, or both 0, to the last bit. So no ray slips through between the
     * triangles.</p>
     *
     * <p>A ray also meets a triangle if it passes the triangle within the tolerance across which surfaces still touch (Tolerances.SURFACES). So a ray
     * towards a silhouette finds it. In this case it meets the triangle where it passes the edges. The place where it crosses the plane is far from a
     * steep triangle.</p>
     *
     * @private
     */
    public final class ShearedRay
    {
        // A triangle is seen edge on if twice its area across the ray is at most so many tolerances times its width, which is the sum of its corners'
        // distances from the ray along u and v. The place where the ray crosses its plane is then a rounding error, so the places where the ray passes
        // its edges count. Of two triangles at one place, one that is not seen edge on counts, because its normal is against the ray.
        private static const EDGE_ON_TOLERANCES:Number = 16;

        // How many tolerances high a triangle may be, over its longest side, if it is seen edge on with the ray inside of it. Its width is at most 2 times that
        // side, times the root of two because u and v are added. 3 is a little more than that.
        private static const EDGE_ON_HEIGHT:Number = 3 * EDGE_ON_TOLERANCES;

        // How many tolerances the place where a ray meets a triangle may be off. The ray may pass a tolerance beside the place that is tested. 4 leaves
        // room for another triangle that touches this one.
        private static const PLACE_TOLERANCES:Number = 4;

        private var _ray:Ray = null;

        // The axes, u, v and w: the ray goes fastest along w.
        private var _u:int;
        private var _v:int;
        private var _w:int;

        // A point of the line, along these axes. How far the line goes along u and v while it goes 1 along w. 1 over its speed along w.
        private var _originU:Number = 0;
        private var _originV:Number = 0;
        private var _originW:Number = 0;
        private var _shearU:Number = 0;
        private var _shearV:Number = 0;
        private var _inverseSpeed:Number = 0;

        // The radius of a sphere around all triangles that come next.
        private var _radius:Number = 0;

        /** The first crossing so far: see <code>findEarlier()</code>. Read only. */
        public var first:RayCrossing = new RayCrossing();

        // The crossing that is tried.
        private var _crossing:RayCrossing = new RayCrossing();
        private var _plane:TrianglePlane = new TrianglePlane();
        private var _corners:Vector.<Number> = new Vector.<Number>(9, true);

        /**
         * Sets the ray. There is no first crossing yet.
         *
         * @param ray in the space of the triangles; the object is kept
         * @param radius of a sphere around all triangles
         */
        public function setTo(ray:Ray, radius:Number):void
        {
            _ray = ray;
            first.distance = Infinity;
            var absX:Number = Math.abs(ray.direction.x);
            var absY:Number = Math.abs(ray.direction.y);
            var absZ:Number = Math.abs(ray.direction.z);
            _w = absY > absZ ? 1 : 2;
            _w = absX > absY && absX > absZ ? 0 : _w;
            _u = (_w + 1) % 3;
            _v = (_w + 2) % 3;
            _originU = along(_u, ray.origin.x, ray.origin.y, ray.origin.z);
            _originV = along(_v, ray.origin.x, ray.origin.y, ray.origin.z);
            _originW = along(_w, ray.origin.x, ray.origin.y, ray.origin.z);
            var speed:Number = along(_w, ray.direction.x, ray.direction.y, ray.direction.z);
            _inverseSpeed = 1 / speed;
            _shearU = along(_u, ray.direction.x, ray.direction.y, ray.direction.z) / speed;
            _shearV = along(_v, ray.direction.x, ray.direction.y, ray.direction.z) / speed;
            setRadius(radius);
        }

        private static function along(axis:int, x:Number, y:Number, z:Number):Number
        {
            return axis == 0 ? x : (axis == 1 ? y : z);
        }

        /** Changes the radius of a sphere around all triangles that come next. Their rounding errors are relative to it. */
        public function setRadius(radius:Number):void
        {
            _radius = radius;
        }

        /**
         * Finds where the ray meets a triangle, and makes it the first crossing if it is before the first one so far.
         *
         * @param points coordinates of points
         * @param a index at which the coordinates of a corner begin
         * @param b index at which those of the next corner begin
         * @param c index at which those of the last corner begin
         * @return whether it is earlier
         */
        public function findEarlier(points:Vector.<Number>, a:int, b:int, c:int):Boolean
        {
            if (!findCrossing(points, a, b, c, _crossing) || !isBeforeFirst(_crossing))
            {
                return false;
            }
            var later:RayCrossing = first;
            first = _crossing;
            _crossing = later;
            return true;
        }

        /**
         * Adds the crossing with a triangle, if there is one.
         *
         * @param corners nine numbers of the triangle
         * @param triangle the triangle's number in the model; -1 if it has none
         * @param out the crossing is added to it
         */
        public function addCrossing(corners:Vector.<Number>, triangle:int, out:RayCrossings):void
        {
            var crossing:RayCrossing = out.add();
            if (findCrossing(corners, 0, 3, 6, crossing) && crossing.distance <= _ray.to)
            {
                writeSurface(corners, triangle, crossing);
            }
            else
            {
                out.count--;
            }
        }

        /**
         * Writes the first crossing. The normal of a flat triangle is the opposite of the ray's direction.
         *
         * @param corners nine numbers of its triangle
         * @param triangle the triangle's number in the model; -1 if it has none
         */
        public function writeFirst(corners:Vector.<Number>, triangle:int, out:RayCrossing):void
        {
            out.distance = first.distance;
            writeSurface(corners, triangle, out);
        }

        private function writeSurface(corners:Vector.<Number>, triangle:int, out:RayCrossing):void
        {
            out.triangle = triangle;
            _plane.setTriangle(corners, 0);
            out.setNormal(_ray, _plane.normal);
        }

        // Whether a crossing comes before the first one so far, and not after the ray's end. A triangle that is seen edge on has to be a rounding
        // error nearer, and another one may be a rounding error behind it.
        private function isBeforeFirst(crossing:RayCrossing):Boolean
        {
            var latest:Number = first.side == RayCrossing.EDGE_ON ? first.distance + first.rounding : first.distance;
            var distance:Number = crossing.side == RayCrossing.EDGE_ON ? crossing.distance + crossing.rounding : crossing.distance;
            return crossing.distance <= _ray.to && distance < latest;
        }

        // Finds where the line meets a triangle, where the ray begins or later. It shears the corners as seen from the line, finds the sides on which
        // the ray passes the edges, and finds where the ray crosses the plane. Returns whether there is such a place.
        private function findCrossing(points:Vector.<Number>, a:int, b:int, c:int, out:RayCrossing):Boolean
        {
            var u:int = _u;
            var v:int = _v;
            var w:int = _w;
            var originU:Number = _originU;
            var originV:Number = _originV;
            var originW:Number = _originW;
            var shearU:Number = _shearU;
            var shearV:Number = _shearV;
            // how far from the triangle the ray may pass
            var tolerance:Number = Tolerances.SURFACES * _radius;
            // Twice the area of a triangle of that height and of the greatest possible width. Shearing may make a side longer than the diameter, by a
            // factor of at most the root of eight.
            var areaTolerance:Number = 6 * tolerance * _radius;
            var aW:Number = points[int(a + w)] - originW;
            var aU:Number = points[int(a + u)] - originU - shearU * aW;
            var aV:Number = points[int(a + v)] - originV - shearV * aW;
            var bW:Number = points[int(b + w)] - originW;
            var bU:Number = points[int(b + u)] - originU - shearU * bW;
            var bV:Number = points[int(b + v)] - originV - shearV * bW;
            var cW:Number = points[int(c + w)] - originW;
            var cU:Number = points[int(c + u)] - originU - shearU * cW;
            var cV:Number = points[int(c + v)] - originV - shearV * cW;
            var sideA:Number = cU * bV - cV * bU;
            var sideB:Number = aU * cV - aV * cU;
            var sideC:Number = bU * aV - bV * aU;
            if ((sideA < -areaTolerance || sideB < -areaTolerance || sideC < -areaTolerance) && (sideA > areaTolerance || sideB > areaTolerance || sideC > areaTolerance))
            {
                return false;
            }
            var sum:Number = sideA + sideB + sideC;
            var width:Number = Math.abs(aU) + Math.abs(aV) + Math.abs(bU) + Math.abs(bV) + Math.abs(cU) + Math.abs(cV);
            var isEdgeOn:Boolean = Math.abs(sum) <= EDGE_ON_TOLERANCES * tolerance * width;
            var isInside:Boolean = sum != 0 && (sideA >= 0 && sideB >= 0 && sideC >= 0 || sideA <= 0 && sideB <= 0 && sideC <= 0);
            if (isInside && !isEdgeOn)
            {
                out.distance = _inverseSpeed * (sideA * aW + sideB * bW + sideC * cW) / sum;
            }
            else if (!passEdges(points, a, b, c, isInside ? EDGE_ON_HEIGHT * tolerance : tolerance, out))
            {
                return false;
            }
            // the comparison is false for NaN too
            if (!(out.distance >= _ray.from || beginsOn(points, a, b, c, out)))
            {
                return false;
            }
            if (isEdgeOn)
            {
                out.rounding = Tolerances.ROUNDING * Math.abs(out.distance) + PLACE_TOLERANCES * EDGE_ON_TOLERANCES * tolerance;
                out.end = Math.max(out.end, out.distance) + out.rounding;
                out.side = RayCrossing.EDGE_ON;
                return true;
            }
            // The ray may pass a tolerance beside the place that is tested. On a steep triangle, which is deep for its area, the place is then farther off
            // along the ray.
            var depth:Number = Math.abs(_inverseSpeed) * (Math.abs(aW - bW) + Math.abs(bW - cW));
            out.rounding = Tolerances.ROUNDING * Math.abs(out.distance) + PLACE_TOLERANCES * tolerance * (1 + width * depth / Math.abs(sum));
            out.side = _inverseSpeed * sum > 0 ? RayCrossing.ENTERS : RayCrossing.LEAVES;
            return true;
        }

        // Whether the ray begins on a triangle up to the tolerance, so that only rounding puts the crossing before the ray. The crossing is then where the
        // ray begins. The triangle is not seen edge on.
        private function beginsOn(points:Vector.<Number>, a:int, b:int, c:int, out:RayCrossing):Boolean
        {
            for (var i:int = 0; i < 3; i++)
            {
                _corners[i] = points[int(a + i)];
                _corners[int(3 + i)] = points[int(b + i)];
                _corners[int(6 + i)] = points[int(c + i)];
            }
            _plane.setTriangle(_corners, 0);
            var gap:Number = (_ray.from - out.distance) * _plane.normal.dotProduct(_ray.direction);
            out.distance = _ray.from;
            return !_plane.isFlat && Math.abs(gap) <= Tolerances.SURFACES * _radius && beginsWithinEdges();
        }

        // Whether the ray begins within the edges of the triangle in _corners, as seen along its normal. A ray that runs nearly along the triangle may begin
        // far beside it.
        private function beginsWithinEdges():Boolean
        {
            var n:Vector3D = _plane.normal;
            var x:Number = _ray.origin.x + _ray.from * _ray.direction.x;
            var y:Number = _ray.origin.y + _ray.from * _ray.direction.y;
            var z:Number = _ray.origin.z + _ray.from * _ray.direction.z;
            for (var at:int = 0; at < 9; at += 3)
            {
                var next:int = (at + 3) % 9;
                var edgeX:Number = _corners[next] - _corners[at];
                var edgeY:Number = _corners[int(next + 1)] - _corners[int(at + 1)];
                var edgeZ:Number = _corners[int(next + 2)] - _corners[int(at + 2)];
                // towards the inside of the triangle, as long as the edge
                var inX:Number = n.y * edgeZ - n.z * edgeY;
                var inY:Number = n.z * edgeX - n.x * edgeZ;
                var inZ:Number = n.x * edgeY - n.y * edgeX;
                var inside:Number = inX * (x - _corners[at]) + inY * (y - _corners[int(at + 1)]) + inZ * (z - _corners[int(at + 2)]);
                if (inside < -PLACE_TOLERANCES * Tolerances.SURFACES * _radius * Math.sqrt(inX * inX + inY * inY + inZ * inZ))
                {
                    return false;
                }
            }
            return true;
        }

        // Sets the crossing to the places where the ray first and last passes the edges of a triangle within a tolerance. Returns whether there is such a place
        // where the ray begins or later.
        private function passEdges(points:Vector.<Number>, a:int, b:int, c:int, tolerance:Number, out:RayCrossing):Boolean
        {
            out.distance = Infinity;
            out.end = -Infinity;
            passEdge(points, a, b, tolerance, out);
            passEdge(points, b, c, tolerance, out);
            passEdge(points, c, a, tolerance, out);
            out.distance = Math.max(out.distance, _ray.from);
            return out.end >= _ray.from - tolerance;
        }

        // Widens the crossing by the place where the ray passes an edge, if that is within a tolerance.
        private function passEdge(points:Vector.<Number>, from:int, to:int, tolerance:Number, out:RayCrossing):void
        {
            var fromW:Number = points[from + _w] - _originW;
            var fromU:Number = points[from + _u] - _originU - _shearU * fromW;
            var fromV:Number = points[from + _v] - _originV - _shearV * fromW;
            var toW:Number = points[to + _w] - _originW;
            var toU:Number = points[to + _u] - _originU - _shearU * toW - fromU;
            var toV:Number = points[to + _v] - _originV - _shearV * toW - fromV;
            var square:Number = toU * toU + toV * toV;
            var fraction:Number = square > 0 ? Math.max(0, Math.min(1, -(fromU * toU + fromV * toV) / square)) : 0;
            fromU += fraction * toU;
            fromV += fraction * toV;
            if (fromU * fromU + fromV * fromV <= tolerance * tolerance)
            {
                var distance:Number = _inverseSpeed * (fromW + fraction * (toW - fromW));
                out.distance = Math.min(out.distance, distance);
                out.end = Math.max(out.end, distance);
            }
        }
    }
}
