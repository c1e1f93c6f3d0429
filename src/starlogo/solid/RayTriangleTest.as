package starlogo.solid
{
    import starlogo.geometry.Tolerances;
    import starlogo.hierarchy.BoxTree;
    import starlogo.hierarchy.NodeTest;
    import starlogo.intersection.ray.Ray;
    import starlogo.intersection.ray.RayCrossings;

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
    public final class RayTriangleTest extends NodeTest
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

        // The axes, ordered so that the ray goes fastest along the last.
        private var _u:int;
        private var _v:int;
        private var _w:int;

        // A point of the line. The line's slopes: how far it goes along the first two axes while it goes 1 along the last. 1 over its speed
        // along the last axis.
        private var _x:Number = 0;
        private var _y:Number = 0;
        private var _z:Number = 0;
        private var _shearX:Number = 0;
        private var _shearY:Number = 0;
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
         * @param all receives the crossings with all triangles, without normals; kept. Null if the first triangle is wanted
         */
        public function begin(ray:Ray, corners:Vector.<Number>, radius:Number, all:RayCrossings = null):void
        {
            _ray = ray;
            _all = all;
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
            _x = along(_u, ray.x, ray.y, ray.z);
            _y = along(_v, ray.x, ray.y, ray.z);
            _z = along(_w, ray.x, ray.y, ray.z);
            var speed:Number = along(_w, ray.directionX, ray.directionY, ray.directionZ);
            _stretch = 1 / speed;
            _shearX = along(_u, ray.directionX, ray.directionY, ray.directionZ) / speed;
            _shearY = along(_v, ray.directionX, ray.directionY, ray.directionZ) / speed;
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
        override public function testNode(tree:BoxTree, node:int):void
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
            var x:Number = _x;
            var y:Number = _y;
            var z:Number = _z;
            var shearX:Number = _shearX;
            var shearY:Number = _shearY;
            var sliver:Number = _sliver;
            for (var i:int = first; i < end; i++)
            {
                var corner:int = 9 * i;
                var aZ:Number = corners[int(corner + w)] - z;
                var aX:Number = corners[int(corner + u)] - x - shearX * aZ;
                var aY:Number = corners[int(corner + v)] - y - shearY * aZ;
                corner += 3;
                var bZ:Number = corners[int(corner + w)] - z;
                var bX:Number = corners[int(corner + u)] - x - shearX * bZ;
                var bY:Number = corners[int(corner + v)] - y - shearY * bZ;
                corner += 3;
                var cZ:Number = corners[int(corner + w)] - z;
                var cX:Number = corners[int(corner + u)] - x - shearX * cZ;
                var cY:Number = corners[int(corner + v)] - y - shearY * cZ;
                var sideA:Number = cX * bY - cY * bX;
                var sideB:Number = aX * cY - aY * cX;
                var sideC:Number = bX * aY - bY * aX;
                if (sideA < -sliver || sideB < -sliver || sideC < -sliver)
                {
                    if (sideA > sliver || sideB > sliver || sideC > sliver)
                    {
                        continue;
                    }
                }
                var sum:Number = sideA + sideB + sideC;
                var width:Number = Math.abs(aX) + Math.abs(aY) + Math.abs(bX) + Math.abs(bY) + Math.abs(cX) + Math.abs(cY);
                var isEdgeOn:Boolean = Math.abs(sum) <= EDGE_ON * _margin * width;
                var crossing:Number = isEdgeOn ? passEdges(9 * i) : _stretch * (sideA * aZ + sideB * bZ + sideC * cZ) / sum;
                var slack:Number = isEdgeOn ? Tolerances.ROUNDING * Math.abs(crossing) + 4 * EDGE_ON * _margin : 0;
                // NaN is skipped too
                if (!(crossing >= _ray.from && crossing <= _latest) || (slot >= 0 && crossing + slack >= _latest))
                {
                    continue;
                }
                if (sum == 0 || (sideA < 0 || sideB < 0 || sideC < 0) && (sideA > 0 || sideB > 0 || sideC > 0))
                {
                    if (!isOver(aX, aY, bX, bY, sideC, sum) || !isOver(bX, bY, cX, cY, sideA, sum) || !isOver(cX, cY, aX, aY, sideB, sum)
                            || !isIn(corners, corner, crossing))
                    {
                        continue;
                    }
                }
                hasFound = true;
                if (_all != null)
                {
                    var depth:Number = Math.abs(_stretch) * (Math.abs(aZ - bZ) + Math.abs(bZ - cZ));
                    addCrossing(i, crossing, isEdgeOn, sum, width * depth);
                    continue;
                }
                _latest = Math.min(crossing + slack, _ray.to);
                limit = distance = crossing;
                slot = i;
            }
            return hasFound;
        }

        // Adds the crossing of the triangle in a slot. The ray may pass a gap beside the place that is tested. On a steep triangle the place is then
        // farther off along the ray.
        private function addCrossing(crossed:int, crossing:Number, isEdgeOn:Boolean, sum:Number, spread:Number):void
        {
            var slack:Number = Tolerances.ROUNDING * Math.abs(crossing);
            if (isEdgeOn)
            {
                slack += 4 * EDGE_ON * _margin;
                _all.add(crossing, slack, Math.max(_last, crossing) + slack, RayCrossings.EDGE_ON, crossed);
            }
            else
            {
                slack += 4 * _margin * (1 + spread / Math.abs(sum));
                _all.add(crossing, slack, crossing, sum > 0 ? RayCrossings.ENTERS : RayCrossings.LEAVES, crossed);
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
            var fromZ:Number = _corners[from + _w] - _z;
            var fromX:Number = _corners[from + _u] - _x - _shearX * fromZ;
            var fromY:Number = _corners[from + _v] - _y - _shearY * fromZ;
            var toZ:Number = _corners[to + _w] - _z;
            var toX:Number = _corners[to + _u] - _x - _shearX * toZ - fromX;
            var toY:Number = _corners[to + _v] - _y - _shearY * toZ - fromY;
            var square:Number = toX * toX + toY * toY;
            var share:Number = square > 0 ? Math.max(0, Math.min(1, -(fromX * toX + fromY * toY) / square)) : 0;
            fromX += share * toX;
            fromY += share * toY;
            if (fromX * fromX + fromY * fromY <= 9 * EDGE_ON * EDGE_ON * _margin * _margin)
            {
                var place:Number = _stretch * (fromZ + share * (toZ - fromZ));
                _first = Math.min(_first, place);
                _last = Math.max(_last, place);
            }
        }

        // Whether the ray passes an edge on the triangle's side, or within the gap.
        private function isOver(fromX:Number, fromY:Number, toX:Number, toY:Number, side:Number, sum:Number):Boolean
        {
            toX -= fromX;
            toY -= fromY;
            return side == 0 || side > 0 == sum > 0 || side * side <= _margin * _margin * (toX * toX + toY * toY);
        }

        // Whether a point of the ray is within a triangle's extents, enlarged by the gap.
        private function isIn(corners:Vector.<Number>, corner:int, crossing:Number):Boolean
        {
            return isBetween(_ray.x + crossing * _ray.directionX, corners, corner)
                && isBetween(_ray.y + crossing * _ray.directionY, corners, corner + 1)
                && isBetween(_ray.z + crossing * _ray.directionZ, corners, corner + 2);
        }

        private function isBetween(place:Number, corners:Vector.<Number>, last:int):Boolean
        {
            var a:Number = corners[int(last - 6)];
            var b:Number = corners[int(last - 3)];
            var c:Number = corners[last];
            return (a - place <= _margin || b - place <= _margin || c - place <= _margin)
                && (place - a <= _margin || place - b <= _margin || place - c <= _margin);
        }
    }
}
