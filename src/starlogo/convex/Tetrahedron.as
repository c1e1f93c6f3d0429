package starlogo.convex
{
    /** Finds the point of a tetrahedron that is nearest to the origin: the origin itself if it is inside, or a point of the faces that it is beyond. */
    internal final class Tetrahedron
    {
        /**
         * Finds the point. The face of the first three corners has no nearer point than before, because the fourth corner was nearer.
         *
         * @param simplex has four corners; the last one is the newest. Its nearest point is that of the first three, with a squared distance of Infinity.
         *     It becomes the nearest one of all four corners, or the origin with its weights. The squared distance stays Infinity if rounding hides
         *     which part is nearest
         * @param isApart whether it is known that the origin is outside
         * @return whether the origin is inside
         */
        public static function find(simplex:Simplex, isApart:Boolean):Boolean
        {
            var out:NearestPoint = simplex.nearest;
            var w:Vector.<Number> = simplex.corners;
            var weights:Vector.<Number> = out.weights;
            weights[3] = 0;
            var isFlat:Boolean = !moveToOrigin(simplex, out);
            var isBeyond01:Boolean = isFlat || weights[2] < 0;
            var isBeyond12:Boolean = isFlat || weights[0] < 0;
            var isBeyond20:Boolean = isFlat || weights[1] < 0;
            var isBeyondNone:Boolean = !isBeyond01 && !isBeyond12 && !isBeyond20;
            if (isBeyondNone && !isApart && weights[3] >= 0)
            {
                out.squaredDistance = out.x = out.y = out.z = 0;
                return true;
            }
            if (isBeyond01 || isBeyondNone)
            {
                SimplexPart.tryTriangle(w, 3, 0, 1, 3, out);
            }
            if (isBeyond12 || isBeyondNone)
            {
                SimplexPart.tryTriangle(w, 3, 1, 2, 3, out);
            }
            if (isBeyond20 || isBeyondNone)
            {
                SimplexPart.tryTriangle(w, 3, 2, 0, 3, out);
            }
            return false;
        }

        // Changes the weights of a tetrahedron's corners from those of the point to those of the origin. The vector from the point to the origin is
        // taken apart along an edge, then along what another edge from the same corner has across it, then along what the third has across both
        // (Gram and Schmidt). So the weights make the origin up to rounding, however narrow the tetrahedron is. Returns false if it is flat.
        private static function moveToOrigin(simplex:Simplex, point:NearestPoint):Boolean
        {
            var w:Vector.<Number> = simplex.corners;
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
            var least:Number = 4 * simplex.rounding * simplex.rounding;
            if (!(vv > least && tt > least))
            {
                return false;
            }
            var x:Number = point.x;
            var y:Number = point.y;
            var z:Number = point.z;
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
            var weights:Vector.<Number> = point.weights;
            weights[0] += ofU;
            weights[1] += ofV;
            weights[2] += ofT;
            weights[3] -= ofU + ofV + ofT;
            return true;
        }
    }
}
