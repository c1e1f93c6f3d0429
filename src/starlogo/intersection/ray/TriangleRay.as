package starlogo.intersection.ray
{
    import starlogo.geometry.Tolerances;

    /**
     * Finds the first of some triangles that a ray meets, from either side: Woop, Benthin and Wald, "Watertight Ray/Triangle Intersection", Journal of
     * Computer Graphics Techniques 2(1), 2013, in double precision.
     *
     * <p>Corners are sheared so that the ray runs along an axis; the side on which it passes an edge is then the sign of one expression, which for
     * the two triangles of an edge comes to opposite numbers, or to 0 for both, to the last bit: no ray slips through between them. A ray that
     * passes a triangle no farther than the gap across which surfaces still touch (Tolerances.SURFACES) meets it, so that one towards a silhouette does.
     * Then the point must be within the triangle's extents, as much wider: a hierarchy's boxes hold it.</p>
     *
     * @private
     */
    public final class TriangleRay
    {
        /** Where the ray meets the nearest triangle so far, as in Ray; before there is one, where it ends. */
        public var at:Number = Infinity;

        /** The nearest triangle so far, or -1. */
        public var triangle:int = -1;

        private var _ray:Ray = null;

        // The axes, that along which the ray goes fastest last.
        private var _u:int;
        private var _v:int;
        private var _w:int;

        // A point of the line, and how far it goes along the first two in a length of 1 along the last; 1 over how fast it goes along that.
        private var _x:Number = 0;
        private var _y:Number = 0;
        private var _z:Number = 0;
        private var _shearX:Number = 0;
        private var _shearY:Number = 0;
        private var _stretch:Number = 0;

        // How far a ray may pass a triangle, and twice the area of one as wide as all and as high as that.
        private var _gap:Number = 0;
        private var _sliver:Number = 0;

        /** Nothing to find yet. */
        public function TriangleRay()
        {
        }

        /**
         * Begins with a ray.
         *
         * @param ray in the space of the triangles; is kept
         * @param radius of a sphere around all of them
         */
        public function begin(ray:Ray, radius:Number):void
        {
            _ray = ray;
            at = ray.to;
            triangle = -1;
            var speedX:Number = ray.directionX;
            var speedY:Number = ray.directionY;
            var speedZ:Number = ray.directionZ;
            var absX:Number = speedX < 0 ? -speedX : speedX;
            var absY:Number = speedY < 0 ? -speedY : speedY;
            var absZ:Number = speedZ < 0 ? -speedZ : speedZ;
            if (absX > absY && absX > absZ)
            {
                _u = 1;
                _v = 2;
                _w = 0;
                _x = ray.y;
                _y = ray.z;
                _z = ray.x;
                _stretch = 1 / speedX;
                _shearX = speedY / speedX;
                _shearY = speedZ / speedX;
            }
            else if (absY > absZ)
            {
                _u = 2;
                _v = 0;
                _w = 1;
                _x = ray.z;
                _y = ray.x;
                _z = ray.y;
                _stretch = 1 / speedY;
                _shearX = speedZ / speedY;
                _shearY = speedX / speedY;
            }
            else
            {
                _u = 0;
                _v = 1;
                _w = 2;
                _x = ray.x;
                _y = ray.y;
                _z = ray.z;
                _stretch = 1 / speedZ;
                _shearX = speedX / speedZ;
                _shearY = speedY / speedZ;
            }
            _gap = Tolerances.SURFACES * radius;
            // a side may be longer than the diameter once it is sheared: by the root of eight at most
            _sliver = 6 * _gap * radius;
        }

        /**
         * Looks for a nearer triangle among some. The arithmetic of each, in this order: its corners as seen from the line, sheared; the
         * sides on which the ray passes the edges; where it crosses the plane.
         *
         * @param corners nine numbers a triangle
         * @param first the first triangle
         * @param end the one after the last
         */
        public function look(corners:Vector.<Number>, first:int, end:int):void
        {
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
                var crossing:Number = _stretch * (sideA * aZ + sideB * bZ + sideC * cZ) / sum;
                // false for NaN too: seen edge on, it is no more than its edges, which others have
                if (!(crossing >= _ray.from && crossing <= at) || (crossing == at && triangle >= 0))
                {
                    continue;
                }
                if ((sideA < 0 || sideB < 0 || sideC < 0) && (sideA > 0 || sideB > 0 || sideC > 0))
                {
                    if (!isOver(aX, aY, bX, bY, sideC, sum) || !isOver(bX, bY, cX, cY, sideA, sum) || !isOver(cX, cY, aX, aY, sideB, sum)
                            || !isIn(corners, corner, crossing))
                    {
                        continue;
                    }
                }
                at = crossing;
                triangle = i;
            }
        }

        // Whether the ray passes an edge on the triangle's side, or no farther away than the gap.
        private function isOver(fromX:Number, fromY:Number, toX:Number, toY:Number, side:Number, sum:Number):Boolean
        {
            toX -= fromX;
            toY -= fromY;
            return side == 0 || side > 0 == sum > 0 || side * side <= _gap * _gap * (toX * toX + toY * toY);
        }

        // Whether a point of the ray is within a triangle's extents, or no farther away than the gap.
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
            return (a - place <= _gap || b - place <= _gap || c - place <= _gap)
                && (place - a <= _gap || place - b <= _gap || place - c <= _gap);
        }
    }
}
