package starlogo.convex
{
    import starlogo.geometry.Tolerances;

    /**
     * The simplex of GjkDistance: a point, segment, triangle or tetrahedron of differences of two cores' points. Its fields are read only.
     */
    internal final class Simplex
    {
        /** The origin is inside of the simplex. */
        public static const INSIDE:int = 0;

        /** The origin is outside, and the nearest point is found. */
        public static const OUTSIDE:int = 1;

        /** Rounding hides which part of the simplex is nearest, so there is no nearest point. */
        public static const UNDECIDED:int = 2;

        /** For reduce(): no corner is the newest, so any part may be the nearest. */
        public static const NO_NEWEST:int = -1;

        /** How many corners there are, and their coordinates. */
        public var count:int = 0;
        public var corners:Vector.<Number> = new Vector.<Number>(12, true);

        /** The rounding error of a corner. */
        public var rounding:Number = 0;

        /** The point nearest to the origin. */
        public var nearest:NearestPoint = new NearestPoint();

        // For each corner, the points of both cores that it is the difference of, as indices of their first numbers.
        private var _ofFirst:Vector.<int> = new Vector.<int>(4, true);
        private var _ofSecond:Vector.<int> = new Vector.<int>(4, true);

        /** Begins without corners. */
        public function begin(cores:CorePair):void
        {
            rounding = Tolerances.CORE_POINTS * (cores.first.boundingRadius + cores.second.boundingRadius + Math.abs(cores.x) + Math.abs(cores.y) + Math.abs(cores.z));
            count = 0;
        }

        /** Computes all corners again, after the first core has moved, and the nearest point. Without corners, only its direction stays. */
        public function recompute(cores:CorePair):void
        {
            // A tetrahedron around the origin says nothing about where the cores are nearest once they are apart.
            var kept:int = count > 3 ? 1 : count;
            begin(cores);
            for (; count < kept; count++)
            {
                writeCorner(cores, count);
            }
            if (kept > 0)
            {
                reduce(NO_NEWEST, false);
            }
        }

        /** Adds the difference of two points, given as the indices of their first numbers. Returns false if it is a corner already. */
        public function add(cores:CorePair, ofFirst:int, ofSecond:int):Boolean
        {
            for (var i:int = 0; i < count; i++)
            {
                if (_ofFirst[i] == ofFirst && _ofSecond[i] == ofSecond)
                {
                    return false;
                }
            }
            _ofFirst[count] = ofFirst;
            _ofSecond[count] = ofSecond;
            writeCorner(cores, count);
            count++;
            return true;
        }

        /**
         * Finds the point nearest to the origin, and drops the corners that have no share of it.
         *
         * <ul>
         * <li>INSIDE: of four corners. The nearest point is the origin, and all corners stay</li>
         * <li>OUTSIDE: the nearest point is of a corner, an edge or a triangle, whose corners stay</li>
         * <li>UNDECIDED: the last corner is dropped. It brings the simplex no nearer</li>
         * </ul>
         *
         * @param newest the corner that was added last, which the point includes, or NO_NEWEST
         * @param isApart whether it is known that the cores are apart
         * @return INSIDE, OUTSIDE or UNDECIDED
         */
        public function reduce(newest:int, isApart:Boolean):int
        {
            nearest.squaredDistance = Infinity;
            switch (count)
            {
                case 1:
                    SimplexPart.tryCorner(corners, 0, nearest);
                    break;
                case 2:
                    SimplexPart.tryEdge(corners, 0, 1, newest, nearest);
                    break;
                case 3:
                    SimplexPart.tryTriangle(corners, 0, 1, 2, newest, nearest);
                    break;
                case 4:
                    if (tryTetrahedron(isApart))
                    {
                        return INSIDE;
                    }
            }
            if (nearest.squaredDistance == Infinity)
            {
                count--;
                return UNDECIDED;
            }
            dropCorners();
            return OUTSIDE;
        }

        /** Writes the point of the first core that the nearest point is made of, where the core is stored. */
        public function writePoint(cores:CorePair, out:CoreGap):void
        {
            var points:Vector.<Number> = cores.first.points;
            var weights:Vector.<Number> = nearest.weights;
            var x:Number = 0;
            var y:Number = 0;
            var z:Number = 0;
            for (var i:int = 0; i < count; i++)
            {
                var fraction:Number = weights[i];
                var at:int = _ofFirst[i];
                x += fraction * points[at];
                y += fraction * points[int(at + 1)];
                z += fraction * points[int(at + 2)];
            }
            out.point.x = x + cores.first.origin.x;
            out.point.y = y + cores.first.origin.y;
            out.point.z = z + cores.first.origin.z;
        }

        // Finds the point of a tetrahedron that is nearest to the origin: the origin itself if it is inside, or a point of the faces that it is beyond. The
        // face of the first three corners has no nearer point than before, because the fourth corner, the newest, was nearer. The squared distance stays
        // Infinity if rounding hides which part is nearest. Returns whether the origin is inside.
        private function tryTetrahedron(isApart:Boolean):Boolean
        {
            var weights:Vector.<Number> = nearest.weights;
            weights[3] = 0;
            var isFlat:Boolean = !moveToOrigin();
            var isBeyond01:Boolean = isFlat || weights[2] < 0;
            var isBeyond12:Boolean = isFlat || weights[0] < 0;
            var isBeyond20:Boolean = isFlat || weights[1] < 0;
            var isBeyondNone:Boolean = !isBeyond01 && !isBeyond12 && !isBeyond20;
            if (isBeyondNone && !isApart && weights[3] >= 0)
            {
                nearest.squaredDistance = nearest.x = nearest.y = nearest.z = 0;
                return true;
            }
            if (isBeyond01 || isBeyondNone)
            {
                SimplexPart.tryTriangle(corners, 3, 0, 1, 3, nearest);
            }
            if (isBeyond12 || isBeyondNone)
            {
                SimplexPart.tryTriangle(corners, 3, 1, 2, 3, nearest);
            }
            if (isBeyond20 || isBeyondNone)
            {
                SimplexPart.tryTriangle(corners, 3, 2, 0, 3, nearest);
            }
            return false;
        }

        // Changes the weights of a tetrahedron's corners from those of the point to those of the origin. The vector from the point to the origin is
        // taken apart along an edge, then along what another edge from the same corner has across it, then along what the third has across both
        // (Gram and Schmidt). So the weights make the origin up to rounding, however narrow the tetrahedron is. Returns false if it is flat.
        private function moveToOrigin():Boolean
        {
            var w:Vector.<Number> = corners;
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
            var x:Number = nearest.x;
            var y:Number = nearest.y;
            var z:Number = nearest.z;
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
            var weights:Vector.<Number> = nearest.weights;
            weights[0] += ofU;
            weights[1] += ofV;
            weights[2] += ofT;
            weights[3] -= ofU + ofV + ofT;
            return true;
        }

        private function writeCorner(cores:CorePair, corner:int):void
        {
            var first:Vector.<Number> = cores.first.points;
            var second:Vector.<Number> = cores.second.points;
            var ofFirst:int = _ofFirst[corner];
            var ofSecond:int = _ofSecond[corner];
            var at:int = 3 * corner;
            corners[at] = first[ofFirst] - second[ofSecond] + cores.x;
            corners[int(at + 1)] = first[int(ofFirst + 1)] - second[int(ofSecond + 1)] + cores.y;
            corners[int(at + 2)] = first[int(ofFirst + 2)] - second[int(ofSecond + 2)] + cores.z;
        }

        // Keeps the corners that have a share of the nearest point.
        private function dropCorners():void
        {
            var weights:Vector.<Number> = nearest.weights;
            var kept:int = 0;
            for (var i:int = 0; i < count; i++)
            {
                if (weights[i] > 0)
                {
                    if (kept < i)
                    {
                        weights[kept] = weights[i];
                        _ofFirst[kept] = _ofFirst[i];
                        _ofSecond[kept] = _ofSecond[i];
                        for (var c:int = 0; c < 3; c++)
                        {
                            corners[int(3 * kept + c)] = corners[int(3 * i + c)];
                        }
                    }
                    kept++;
                }
            }
            count = kept;
        }
    }
}
