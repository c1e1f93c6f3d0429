package starlogo.convex
{
    import flash.geom.Vector3D;
    import starlogo.geometry.Tolerances;

    /**
     * The point of a simplex that is nearest to the origin.
     *
     * <p>In a triangle it is located along the longest edge first and then across it. The direction to it is the triangle's own normal where
     * that is more precise than the vector to the point. So needles and tiny distances lose no digits.</p>
     *
     * <p>Its fields are read only, but Simplex moves the shares of the corners that it keeps.</p>
     */
    internal final class NearestPoint
    {
        /** The origin is inside of the simplex. */
        public static const INSIDE:int = 0;

        /** The origin is outside, and the point is found. */
        public static const OUTSIDE:int = 1;

        /** Rounding hides which part of the simplex is nearest, so there is no point. */
        public static const LOST:int = 2;

        /** The point, and its squared distance. */
        public var x:Number = 0;
        public var y:Number = 0;
        public var z:Number = 0;
        public var squaredDistance:Number = 0;

        /** The direction from the origin to the point, of any length. It may be more precise than the point itself. */
        public var direction:Vector3D = new Vector3D();

        /** For each corner, its share of the point. */
        public var shares:Vector.<Number> = new Vector.<Number>(4, true);

        /** The rounding error of a corner. */
        public var rounding:Number = 0;

        // The simplex's corners.
        private var _corners:Vector.<Number>;

        /** @param corners of the simplex, x, y, z of each; kept */
        public function NearestPoint(corners:Vector.<Number>)
        {
            _corners = corners;
        }

        /** Begins with two cores, which the rounding error depends on. */
        public function begin(cores:CorePair):void
        {
            rounding = Tolerances.CORE_POINTS * (cores.first.extent + cores.second.extent + Math.abs(cores.x) + Math.abs(cores.y) + Math.abs(cores.z));
        }

        /**
         * Finds the point.
         *
         * @param count how many corners there are. If there are four, the point before is that of the first three
         * @param newest the corner that was added last. No part without it is nearest, because the simplex before was nearer than that. -1 if any part
         *     may be
         * @param isApart whether it is known that the cores are apart
         * @return INSIDE, OUTSIDE or LOST
         */
        public function find(count:int, newest:int, isApart:Boolean):int
        {
            squaredDistance = Infinity;
            if (count == 1)
            {
                tryCorner(0);
            }
            else if (count == 2)
            {
                tryEdge(0, 1, newest);
            }
            else if (count == 3)
            {
                tryTriangle(0, 1, 2, newest);
            }
            else if (tryTetrahedron(isApart))
            {
                return INSIDE;
            }
            return squaredDistance == Infinity ? LOST : OUTSIDE;
        }

        // Returns whether the origin is inside of the tetrahedron. If not, tries the faces that the origin is beyond; the face of the first three
        // corners is none of them, because the fourth corner was nearer. The shares are those of the nearest point in that face until now.
        private function tryTetrahedron(isApart:Boolean):Boolean
        {
            shares[3] = 0;
            var isFlat:Boolean = !moveToOrigin();
            var isBeyond01:Boolean = isFlat || shares[2] < 0;
            var isBeyond12:Boolean = isFlat || shares[0] < 0;
            var isBeyond20:Boolean = isFlat || shares[1] < 0;
            var isBeyondNone:Boolean = !isBeyond01 && !isBeyond12 && !isBeyond20;
            if (isBeyondNone && !isApart && shares[3] >= 0)
            {
                squaredDistance = x = y = z = 0;
                return true;
            }
            if (isBeyond01 || isBeyondNone)
            {
                tryTriangle(3, 0, 1, 3);
            }
            if (isBeyond12 || isBeyondNone)
            {
                tryTriangle(3, 1, 2, 3);
            }
            if (isBeyond20 || isBeyondNone)
            {
                tryTriangle(3, 2, 0, 3);
            }
            return false;
        }

        // Changes the shares of a tetrahedron's corners from those of the point to those of the origin. The vector from the point to the origin is
        // taken apart along an edge, then along what another edge from the same corner has across it, then along what the third has across both
        // (Gram and Schmidt). So the shares make the origin up to rounding, however narrow the tetrahedron is. Returns false if it is flat.
        private function moveToOrigin():Boolean
        {
            var w:Vector.<Number> = _corners;
            var ux:Number = w[0] - w[9];
            var uy:Number = w[1] - w[10];
            var uz:Number = w[2] - w[11];
            var uu:Number = ux * ux + uy * uy + uz * uz;
            var vx:Number = w[3] - w[9];
            var vy:Number = w[4] - w[10];
            var vz:Number = w[5] - w[11];
            var vAlongU:Number = (vx * ux + vy * uy + vz * uz) / uu;
            vx -= vAlongU * ux;
            vy -= vAlongU * uy;
            vz -= vAlongU * uz;
            var vv:Number = vx * vx + vy * vy + vz * vz;
            var tx:Number = w[6] - w[9];
            var ty:Number = w[7] - w[10];
            var tz:Number = w[8] - w[11];
            var tAlongU:Number = (tx * ux + ty * uy + tz * uz) / uu;
            tx -= tAlongU * ux;
            ty -= tAlongU * uy;
            tz -= tAlongU * uz;
            var tAlongV:Number = (tx * vx + ty * vy + tz * vz) / vv;
            tx -= tAlongV * vx;
            ty -= tAlongV * vy;
            tz -= tAlongV * vz;
            var tt:Number = tx * tx + ty * ty + tz * tz;
            var least:Number = 4 * rounding * rounding;
            if (!(vv > least && tt > least))
            {
                return false;
            }
            var alongU:Number = -(x * ux + y * uy + z * uz) / uu;
            var toX:Number = -x - alongU * ux;
            var toY:Number = -y - alongU * uy;
            var toZ:Number = -z - alongU * uz;
            var alongV:Number = (toX * vx + toY * vy + toZ * vz) / vv;
            toX -= alongV * vx;
            toY -= alongV * vy;
            toZ -= alongV * vz;
            var ofT:Number = (toX * tx + toY * ty + toZ * tz) / tt;
            var ofV:Number = alongV - tAlongV * ofT;
            var ofU:Number = alongU - vAlongU * ofV - tAlongU * ofT;
            shares[0] += ofU;
            shares[1] += ofV;
            shares[2] += ofT;
            shares[3] -= ofU + ofV + ofT;
            return true;
        }

        private function tryCorner(i:int):void
        {
            var at:int = 3 * i;
            var toX:Number = _corners[at];
            var toY:Number = _corners[int(at + 1)];
            var toZ:Number = _corners[int(at + 2)];
            var squared:Number = toX * toX + toY * toY + toZ * toZ;
            if (squared < squaredDistance)
            {
                squaredDistance = squared;
                clearShares();
                shares[i] = 1;
                x = direction.x = toX;
                y = direction.y = toY;
                z = direction.z = toZ;
            }
        }

        private function tryEdge(i:int, j:int, newest:int):void
        {
            var w:Vector.<Number> = _corners;
            var from:int = 3 * i;
            var to:int = 3 * j;
            var toX:Number = w[from];
            var toY:Number = w[int(from + 1)];
            var toZ:Number = w[int(from + 2)];
            var ux:Number = w[to] - toX;
            var uy:Number = w[int(to + 1)] - toY;
            var uz:Number = w[int(to + 2)] - toZ;
            var uu:Number = ux * ux + uy * uy + uz * uz;
            var along:Number = -(toX * ux + toY * uy + toZ * uz);
            if (!(along > 0) || along >= uu)
            {
                var end:int = along > 0 ? j : i;
                if (newest < 0 || newest == end)
                {
                    tryCorner(end);
                }
                return;
            }
            var share:Number = along / uu;
            toX += share * ux;
            toY += share * uy;
            toZ += share * uz;
            var squared:Number = toX * toX + toY * toY + toZ * toZ;
            if (squared < squaredDistance)
            {
                squaredDistance = squared;
                clearShares();
                shares[i] = 1 - share;
                shares[j] = share;
                x = toX;
                y = toY;
                z = toZ;
                setDirectionAcross(from, to);
            }
        }

        // Sets the direction to the point, but perpendicular to an edge. A short vector to the point is not quite perpendicular.
        private function setDirectionAcross(from:int, to:int):void
        {
            var w:Vector.<Number> = _corners;
            var ux:Number = w[to] - w[from];
            var uy:Number = w[int(to + 1)] - w[int(from + 1)];
            var uz:Number = w[int(to + 2)] - w[int(from + 2)];
            var off:Number = (x * ux + y * uy + z * uz) / (ux * ux + uy * uy + uz * uz);
            direction.x = x - off * ux;
            direction.y = y - off * uy;
            direction.z = z - off * uz;
        }

        // Tries a triangle. Its longest edge becomes the base.
        private function tryTriangle(i:int, j:int, k:int, newest:int):void
        {
            if (!isLonger(i, j, j, k) && !isLonger(k, i, j, k))
            {
                tryTriangleOnBase(j, k, i, newest);
            }
            else if (isLonger(k, i, i, j))
            {
                tryTriangleOnBase(k, i, j, newest);
            }
            else
            {
                tryTriangleOnBase(i, j, k, newest);
            }
        }

        // Tries a triangle on its base, the longest edge, which goes from i to j. If the origin is not over its inside, tries its edges.
        private function tryTriangleOnBase(i:int, j:int, k:int, newest:int):void
        {
            var w:Vector.<Number> = _corners;
            var from:int = 3 * i;
            var to:int = 3 * j;
            var apex:int = 3 * k;
            var toX:Number = w[from];
            var toY:Number = w[int(from + 1)];
            var toZ:Number = w[int(from + 2)];
            var ux:Number = w[to] - toX;
            var uy:Number = w[int(to + 1)] - toY;
            var uz:Number = w[int(to + 2)] - toZ;
            var hx:Number = w[apex] - toX;
            var hy:Number = w[int(apex + 1)] - toY;
            var hz:Number = w[int(apex + 2)] - toZ;
            var uu:Number = ux * ux + uy * uy + uz * uz;
            // the height, from its foot on the base
            var foot:Number = (hx * ux + hy * uy + hz * uz) / uu;
            hx -= foot * ux;
            hy -= foot * uy;
            hz -= foot * uz;
            var hh:Number = hx * hx + hy * hy + hz * hz;
            var along:Number = -(toX * ux + toY * uy + toZ * uz) / uu;
            toX += along * ux;
            toY += along * uy;
            toZ += along * uz;
            var up:Number = -(toX * hx + toY * hy + toZ * hz) / hh;
            var low:Number = along - foot * up;
            if (!(hh > Tolerances.NARROW_TRIANGLE * uu && up > 0 && low > 0 && low < 1 - up))
            {
                tryEdges(i, j, k, newest);
                return;
            }
            toX += up * hx;
            toY += up * hy;
            toZ += up * hz;
            var squared:Number = toX * toX + toY * toY + toZ * toZ;
            if (squared < squaredDistance)
            {
                squaredDistance = squared;
                clearShares();
                shares[i] = 1 - up - low;
                shares[j] = low;
                shares[k] = up;
                x = toX;
                y = toY;
                z = toZ;
                if (squared < hh)
                {
                    // the triangle's normal is more precise than the vector
                    var normalX:Number = uy * hz - uz * hy;
                    var normalY:Number = uz * hx - ux * hz;
                    var normalZ:Number = ux * hy - uy * hx;
                    var side:int = normalX * x + normalY * y + normalZ * z < 0 ? -1 : 1;
                    direction.x = side * normalX;
                    direction.y = side * normalY;
                    direction.z = side * normalZ;
                    return;
                }
                setDirectionAcross(from, to);
            }
        }

        // Tries a triangle's edges, but not the one without the newest corner.
        private function tryEdges(i:int, j:int, k:int, newest:int):void
        {
            if (newest != k)
            {
                tryEdge(i, j, newest);
            }
            if (newest != i)
            {
                tryEdge(j, k, newest);
            }
            if (newest != j)
            {
                tryEdge(k, i, newest);
            }
        }

        // Whether the edge from i to j is longer than the edge from k to l. It compares two, because V8 makes objects for squares that are returned.
        private function isLonger(i:int, j:int, k:int, l:int):Boolean
        {
            var ijX:Number = _corners[int(3 * j)] - _corners[int(3 * i)];
            var ijY:Number = _corners[int(3 * j + 1)] - _corners[int(3 * i + 1)];
            var ijZ:Number = _corners[int(3 * j + 2)] - _corners[int(3 * i + 2)];
            var klX:Number = _corners[int(3 * l)] - _corners[int(3 * k)];
            var klY:Number = _corners[int(3 * l + 1)] - _corners[int(3 * k + 1)];
            var klZ:Number = _corners[int(3 * l + 2)] - _corners[int(3 * k + 2)];
            return ijX * ijX + ijY * ijY + ijZ * ijZ > klX * klX + klY * klY + klZ * klZ;
        }

        private function clearShares():void
        {
            shares[0] = shares[1] = shares[2] = shares[3] = 0;
        }
    }
}
