package starlogo.solid
{
    import starlogo.convex.TrianglePlane;
    import starlogo.geometry.Tolerances;
    import starlogo.hierarchy.BoxTree;
    import starlogo.hierarchy.NodeVisitor;
    import starlogo.intersection.ray.Ray;
    import starlogo.intersection.ray.RayCrossings;
    import starlogo.intersection.ray.RayEntry;

    /**
     * Finds the first triangle that a ray meets, or all of them, from either side (Woop, Benthin and Wald, "Watertight Ray/Triangle Intersection",
     * Journal of Computer Graphics Techniques 2(1), 2013, in double precision).
     *
     * <p>The corners are sheared so that the ray runs along an axis. Then the sign of one expression says on which side the ray passes an
     * edge. For the two triangles of an edge the two values are opposite, or both 0, to the last bit. So no ray slips through between the
     * triangles.</p>
     *
     * <p>A ray also meets a triangle if it passes the triangle within the gap across which surfaces still touch (Tolerances.SURFACES). So a ray
     * towards a silhouette finds it. In this case the point must lie within the triangle's extents, enlarged by the gap, because the
     * hierarchy's boxes contain only such points.</p>
     *
     * @private
     */
    public final class TriangleRayVisitor extends NodeVisitor
    {
        // A triangle is seen edge on if its height across the ray is less than six times so many gaps. The place where the ray crosses its plane
        // is then a rounding error, so the places where the ray passes its edges count. Of two triangles at one place, one that is not seen edge on
        // counts, because its normal is against the ray.
        private static const EDGE_ON:Number = 16;

        /** The slot of the first triangle that the ray meets, of those tested so far; -1 if it meets none. Not set if all are wanted. */
        public var slot:int = -1;

        /** Where the ray meets that triangle: a distance, as the ray counts them. Without meaning if there is none. */
        public var distance:Number = 0;

        private var _ray:Ray = null;
        private var _all:RayCrossings = null;
        private var _corners:Vector.<Number>;
        private var _items:Vector.<int>;

        // The plane of a triangle that the ray meets, and a crossing of all.
        private var _plane:TrianglePlane = new TrianglePlane();
        private var _entry:RayEntry = new RayEntry();

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
        private var _stretch:Number = 0;

        // How far from a triangle the ray may pass. Twice the area of a triangle of that height and of the greatest possible width.
        private var _margin:Number = 0;
        private var _sliver:Number = 0;

        // Where the next triangle must be met to count: the nearest place so far, or a rounding error behind it if that triangle is seen edge on.
        private var _latest:Number = 0;

        // Where the ray first and last passes the edges of a triangle that it sees edge on.
        private var _first:Number = 0;
        private var _last:Number = 0;

        /**
         * Begins with a ray.
         *
         * @param ray in the space of the triangles; the object is kept
         * @param corners nine numbers for each triangle, by slot; kept
         * @param radius of a sphere around all triangles
         * @param all receives the crossings with all triangles; kept. Null if the first triangle is wanted
         * @param items the triangles' numbers in the model, by slot; kept. Null if they have none
         */
        public function begin(ray:Ray, corners:Vector.<Number>, radius:Number, all:RayCrossings = null, items:Vector.<int> = null):void
        {
            _ray = ray;
            _all = all;
            _items = items;
            _corners = corners;
            limit = _latest = ray.to;
            slot = -1;
            var absX:Number = Math.abs(ray.directionX);
            var absY:Number = Math.abs(ray.directionY);
            var absZ:Number = Math.abs(ray.directionZ);
            _w = absY > absZ ? 1 : 2;
            _w = absX > absY && absX > absZ ? 0 : _w;
            _u = (_w + 1) % 3;
            _v = (_w + 2) % 3;
            _originU = along(_u, ray.x, ray.y, ray.z);
            _originV = along(_v, ray.x, ray.y, ray.z);
            _originW = along(_w, ray.x, ray.y, ray.z);
            var speed:Number = along(_w, ray.directionX, ray.directionY, ray.directionZ);
            _stretch = 1 / speed;
            _shearU = along(_u, ray.directionX, ray.directionY, ray.directionZ) / speed;
            _shearV = along(_v, ray.directionX, ray.directionY, ray.directionZ) / speed;
            setRadius(radius);
        }

        private static function along(axis:int, x:Number, y:Number, z:Number):Number
        {
            return axis == 0 ? x : (axis == 1 ? y : z);
        }

        /** Changes the radius of a sphere around all triangles that come next. Their rounding errors are relative to it. */
        public function setRadius(radius:Number):void
        {
            _margin = Tolerances.SURFACES * radius;
            // Shearing may make a side longer than the diameter, by a factor of at most the root of eight.
            _sliver = 6 * _margin * radius;
        }

        /** @inheritDoc */
        override public function visit(tree:BoxTree, node:int):void
        {
            testTriangles(tree.first[node], tree.end[node]);
        }

        /**
         * Tests some triangles.
         *
         * <p>For each one, it shears the corners as seen from the line, finds the sides on which the ray passes the edges, and finds where
         * the ray crosses the plane.</p>
         *
         * @param first the first triangle's slot
         * @param end the slot after the last one
         * @return whether one of them is the nearest so far, or was added to all crossings
         */
        public function testTriangles(first:int, end:int):Boolean
        {
            var hasFound:Boolean = false;
            var corners:Vector.<Number> = _corners;
            var u:int = _u;
            var v:int = _v;
            var w:int = _w;
            var originU:Number = _originU;
            var originV:Number = _originV;
            var originW:Number = _originW;
            var shearU:Number = _shearU;
            var shearV:Number = _shearV;
            var sliver:Number = _sliver;
            for (var i:int = first; i < end; i++)
            {
                var corner:int = 9 * i;
                var aW:Number = corners[int(corner + w)] - originW;
                var aU:Number = corners[int(corner + u)] - originU - shearU * aW;
                var aV:Number = corners[int(corner + v)] - originV - shearV * aW;
                corner += 3;
                var bW:Number = corners[int(corner + w)] - originW;
                var bU:Number = corners[int(corner + u)] - originU - shearU * bW;
                var bV:Number = corners[int(corner + v)] - originV - shearV * bW;
                corner += 3;
                var cW:Number = corners[int(corner + w)] - originW;
                var cU:Number = corners[int(corner + u)] - originU - shearU * cW;
                var cV:Number = corners[int(corner + v)] - originV - shearV * cW;
                var sideA:Number = cU * bV - cV * bU;
                var sideB:Number = aU * cV - aV * cU;
                var sideC:Number = bU * aV - bV * aU;
                if (sideA < -sliver || sideB < -sliver || sideC < -sliver)
                {
                    if (sideA > sliver || sideB > sliver || sideC > sliver)
                    {
                        continue;
                    }
                }
                var sum:Number = sideA + sideB + sideC;
                var width:Number = Math.abs(aU) + Math.abs(aV) + Math.abs(bU) + Math.abs(bV) + Math.abs(cU) + Math.abs(cV);
                var isEdgeOn:Boolean = Math.abs(sum) <= EDGE_ON * _margin * width;
                var crossing:Number = isEdgeOn ? passEdges(9 * i) : _stretch * (sideA * aW + sideB * bW + sideC * cW) / sum;
                var slack:Number = isEdgeOn ? Tolerances.ROUNDING * Math.abs(crossing) + 4 * EDGE_ON * _margin : 0;
                // NaN is skipped too
                if (!(crossing >= _ray.from && crossing <= _latest) || (slot >= 0 && crossing + slack >= _latest))
                {
                    continue;
                }
                if (sum == 0 || (sideA < 0 || sideB < 0 || sideC < 0) && (sideA > 0 || sideB > 0 || sideC > 0))
                {
                    if (!isOver(aU, aV, bU, bV, sideC, sum) || !isOver(bU, bV, cU, cV, sideA, sum) || !isOver(cU, cV, aU, aV, sideB, sum)
                            || !isIn(corners, 9 * i, crossing))
                    {
                        continue;
                    }
                }
                hasFound = true;
                if (_all != null)
                {
                    var depth:Number = Math.abs(_stretch) * (Math.abs(aW - bW) + Math.abs(bW - cW));
                    addCrossing(i, crossing, isEdgeOn, sum, width * depth);
                    continue;
                }
                _latest = Math.min(crossing + slack, _ray.to);
                limit = distance = crossing;
                slot = i;
            }
            return hasFound;
        }

        /** Writes where the ray meets the first triangle, and which one that is. There must be one. */
        public function writeHit(out:RayEntry):void
        {
            writeTriangle(slot, out);
            out.distance = distance;
        }

        // Writes the number and the normal of the triangle in a slot. If it is flat, the normal is the opposite of the ray's direction.
        private function writeTriangle(crossed:int, out:RayEntry):void
        {
            out.begin(_ray);
            out.triangle = _items == null ? -1 : _items[crossed];
            _plane.setTriangle(_corners, 9 * crossed);
            if (!_plane.isFlat)
            {
                out.setNormal(_ray, _plane.normal.x, _plane.normal.y, _plane.normal.z);
            }
        }

        // Adds the crossing of the triangle in a slot. The ray may pass a gap beside the place that is tested. On a steep triangle the place is then
        // farther off along the ray.
        private function addCrossing(crossed:int, crossing:Number, isEdgeOn:Boolean, sum:Number, spread:Number):void
        {
            var slack:Number = Tolerances.ROUNDING * Math.abs(crossing);
            writeTriangle(crossed, _entry);
            _entry.distance = crossing;
            if (isEdgeOn)
            {
                slack += 4 * EDGE_ON * _margin;
                _all.add(_entry, slack, Math.max(_last, crossing) + slack, RayCrossings.EDGE_ON);
            }
            else
            {
                slack += 4 * _margin * (1 + spread / Math.abs(sum));
                _all.add(_entry, slack, crossing, sum > 0 ? RayCrossings.ENTERS : RayCrossings.LEAVES);
            }
        }

        // Finds where the ray first and last passes the edges of a triangle that it sees edge on. Returns where it first meets the triangle; NaN if
        // no edge is near, or none before the ray begins.
        private function passEdges(corner:int):Number
        {
            _first = Infinity;
            _last = -Infinity;
            passEdge(corner, corner + 3);
            passEdge(corner + 3, corner + 6);
            passEdge(corner + 6, corner);
            return _last >= _ray.from ? Math.max(_first, _ray.from) : NaN;
        }

        private function passEdge(from:int, to:int):void
        {
            var fromW:Number = _corners[from + _w] - _originW;
            var fromU:Number = _corners[from + _u] - _originU - _shearU * fromW;
            var fromV:Number = _corners[from + _v] - _originV - _shearV * fromW;
            var toW:Number = _corners[to + _w] - _originW;
            var toU:Number = _corners[to + _u] - _originU - _shearU * toW - fromU;
            var toV:Number = _corners[to + _v] - _originV - _shearV * toW - fromV;
            var square:Number = toU * toU + toV * toV;
            var share:Number = square > 0 ? Math.max(0, Math.min(1, -(fromU * toU + fromV * toV) / square)) : 0;
            fromU += share * toU;
            fromV += share * toV;
            if (fromU * fromU + fromV * fromV <= 9 * EDGE_ON * EDGE_ON * _margin * _margin)
            {
                var place:Number = _stretch * (fromW + share * (toW - fromW));
                _first = Math.min(_first, place);
                _last = Math.max(_last, place);
            }
        }

        // Whether the ray passes an edge on the triangle's side, or within the gap.
        private function isOver(fromU:Number, fromV:Number, toU:Number, toV:Number, side:Number, sum:Number):Boolean
        {
            toU -= fromU;
            toV -= fromV;
            return side == 0 || side > 0 == sum > 0 || side * side <= _margin * _margin * (toU * toU + toV * toV);
        }

        // Whether a point of the ray is within a triangle's extents, enlarged by the gap.
        private function isIn(corners:Vector.<Number>, at:int, crossing:Number):Boolean
        {
            return isBetween(_ray.x + crossing * _ray.directionX, corners, at)
                && isBetween(_ray.y + crossing * _ray.directionY, corners, at + 1)
                && isBetween(_ray.z + crossing * _ray.directionZ, corners, at + 2);
        }

        private function isBetween(place:Number, corners:Vector.<Number>, at:int):Boolean
        {
            var a:Number = corners[at];
            var b:Number = corners[int(at + 3)];
            var c:Number = corners[int(at + 6)];
            return (a - place <= _margin || b - place <= _margin || c - place <= _margin)
                && (place - a <= _margin || place - b <= _margin || place - c <= _margin);
        }
    }
}
