package starlogo.solid
{
    import starlogo.convex.ConvexShape;

    /**
     * A quick test that rules out most pairs of triangles, before ConvexKernel decides. Allocates nothing.
     *
     * <p>The directions that it tries are the second triangle's normal, and those perpendicular to an edge of each. The caller has tried the first
     * triangle's normal, by its TrianglePlane. If each triangle crosses the other's plane, each has one corner alone on its side of that plane. Then
     * only the edges from these two corners can face each other (Guigue and Devillers, "Fast and robust triangle-triangle overlap test using
     * orientation predicates", Journal of Graphics Tools, 2003). If all of a triangle is on one side, it may have no such corner. Any of its corners
     * is taken then, so fewer pairs are ruled out.</p>
     *
     * @private
     */
    internal final class TriangleSeparation
    {
        // The first triangle is beside the second one's plane.
        private static const BESIDE:int = -1;

        // How far apart triangles have to be, as a multiple of the second one's margin. ConvexKernel adds Tolerances.CORES of the extents to the margin,
        // which is less than half of Tolerances.SURFACES.
        private static const MARGINS:Number = 1.5;

        /**
         * Whether a direction is known along which two triangles are farther apart than they may be to touch. If it is false, they may be apart too.
         *
         * @param a nine numbers of the first triangle: x, y, z of each corner
         * @param at index of the first of them in a
         * @param b the second triangle, in the same space. Its margin must be larger than rounding errors, and at least Tolerances.SURFACES of the
         *     coordinates' size
         */
        public static function areApart(a:Vector.<Number>, at:int, b:ConvexShape):Boolean
        {
            var corner:int = cornerAcrossB(a, at, b);
            return corner == BESIDE || areEdgesApart(a, at, corner, b, cornerAcrossA(a, at, b));
        }

        // Returns which corner of a is alone on its side of b's plane; any one if none is; BESIDE if all of a is far enough on one side.
        private static function cornerAcrossB(a:Vector.<Number>, at:int, b:ConvexShape):int
        {
            var p:Vector.<Number> = b.points;
            var fx:Number = p[3];
            var fy:Number = p[4];
            var fz:Number = p[5];
            var gx:Number = p[6];
            var gy:Number = p[7];
            var gz:Number = p[8];
            var x:Number = fy * gz - fz * gy;
            var y:Number = fz * gx - fx * gz;
            var z:Number = fx * gy - fy * gx;
            // where the corners are along b's normal
            var aX:Number = a[at];
            var aY:Number = a[int(at + 1)];
            var aZ:Number = a[int(at + 2)];
            var first:Number = x * (aX - b.x) + y * (aY - b.y) + z * (aZ - b.z);
            var second:Number = first + x * (a[int(at + 3)] - aX) + y * (a[int(at + 4)] - aY) + z * (a[int(at + 5)] - aZ);
            var third:Number = first + x * (a[int(at + 6)] - aX) + y * (a[int(at + 7)] - aY) + z * (a[int(at + 8)] - aZ);
            var low:Number = second < third ? second : third;
            var high:Number = second < third ? third : second;
            low = first < low ? first : low;
            high = first < high ? high : first;
            // For a needle, b's own corners are off the plane that was computed.
            var ownF:Number = x * fx + y * fy + z * fz;
            var ownG:Number = x * gx + y * gy + z * gz;
            ownF = ownF < 0 ? -ownF : ownF;
            ownG = ownG < 0 ? -ownG : ownG;
            var distance:Number = low > 0 ? low : -high;
            distance -= ownF + ownG;
            var least:Number = MARGINS * b.margin;
            if (distance > 0 && distance * distance > least * least * (x * x + y * y + z * z))
            {
                return BESIDE;
            }
            return first * second > 0 ? 2 : first * third > 0 ? 1 : 0;
        }

        // Returns which corner of b is alone on its side of a's plane; any one if none is.
        private static function cornerAcrossA(a:Vector.<Number>, at:int, b:ConvexShape):int
        {
            var p:Vector.<Number> = b.points;
            var aX:Number = a[at];
            var aY:Number = a[int(at + 1)];
            var aZ:Number = a[int(at + 2)];
            var ux:Number = a[int(at + 3)] - aX;
            var uy:Number = a[int(at + 4)] - aY;
            var uz:Number = a[int(at + 5)] - aZ;
            var vx:Number = a[int(at + 6)] - aX;
            var vy:Number = a[int(at + 7)] - aY;
            var vz:Number = a[int(at + 8)] - aZ;
            var x:Number = uy * vz - uz * vy;
            var y:Number = uz * vx - ux * vz;
            var z:Number = ux * vy - uy * vx;
            var first:Number = x * (b.x - aX) + y * (b.y - aY) + z * (b.z - aZ);
            var second:Number = first + x * p[3] + y * p[4] + z * p[5];
            var third:Number = first + x * p[6] + y * p[7] + z * p[8];
            return first * second > 0 ? 2 : first * third > 0 ? 1 : 0;
        }

        // Whether a direction perpendicular to an edge of each keeps the triangles apart. The edges are those at a corner of each.
        private static function areEdgesApart(a:Vector.<Number>, at:int, cornerA:int, b:ConvexShape, cornerB:int):Boolean
        {
            var i:int = at + 3 * cornerA;
            var j:int = cornerA == 2 ? at : i + 3;
            var k:int = cornerA == 0 ? at + 6 : i - 3;
            var p:int = 3 * cornerB;
            var q:int = cornerB == 2 ? 0 : p + 3;
            var r:int = cornerB == 0 ? 6 : p - 3;
            return isApartAcross(a, i, j, k, b, p, q, r) || isApartAcross(a, i, j, k, b, p, r, q)
                || isApartAcross(a, i, k, j, b, p, r, q) || isApartAcross(a, i, k, j, b, p, q, r);
        }

        // Whether the direction perpendicular to a's edge from corner i to j, u, and b's edge from p to q, f, keeps the triangles apart. The other
        // edges at i and p are v and g.
        private static function isApartAcross(a:Vector.<Number>, i:int, j:int, k:int, b:ConvexShape, p:int, q:int, r:int):Boolean
        {
            var points:Vector.<Number> = b.points;
            var aX:Number = a[i];
            var aY:Number = a[int(i + 1)];
            var aZ:Number = a[int(i + 2)];
            var bX:Number = points[p];
            var bY:Number = points[int(p + 1)];
            var bZ:Number = points[int(p + 2)];
            var ux:Number = a[j] - aX;
            var uy:Number = a[int(j + 1)] - aY;
            var uz:Number = a[int(j + 2)] - aZ;
            var fx:Number = points[q] - bX;
            var fy:Number = points[int(q + 1)] - bY;
            var fz:Number = points[int(q + 2)] - bZ;
            var x:Number = uy * fz - uz * fy;
            var y:Number = uz * fx - ux * fz;
            var z:Number = ux * fy - uy * fx;
            var alongU:Number = x * ux + y * uy + z * uz;
            var alongV:Number = x * (a[k] - aX) + y * (a[int(k + 1)] - aY) + z * (a[int(k + 2)] - aZ);
            var low:Number = alongU < alongV ? alongU : alongV;
            var high:Number = alongU < alongV ? alongV : alongU;
            low = low < 0 ? low : 0;
            high = high > 0 ? high : 0;
            var alongF:Number = x * fx + y * fy + z * fz;
            var alongG:Number = x * (points[r] - bX) + y * (points[int(r + 1)] - bY) + z * (points[int(r + 2)] - bZ);
            var lowB:Number = alongF < alongG ? alongF : alongG;
            var highB:Number = alongF < alongG ? alongG : alongF;
            lowB = lowB < 0 ? lowB : 0;
            highB = highB > 0 ? highB : 0;
            var between:Number = x * (b.x - aX + bX) + y * (b.y - aY + bY) + z * (b.z - aZ + bZ);
            low -= between + highB;
            high -= between + lowB;
            var distance:Number = low > 0 ? low : -high;
            var least:Number = MARGINS * b.margin;
            return distance > 0 && distance * distance > least * least * (x * x + y * y + z * z);
        }
    }
}
