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
     * <p>a is the first triangle, a list of nine numbers from an index on. b is the second one, whose points are relative to its first corner. u and v
     * are two edges of a that begin at one corner, f and g two edges of b. (x, y, z) is the direction that is tried, of any length.</p>
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
            var points:Vector.<Number> = b.points;
            var fx:Number = points[3];
            var fy:Number = points[4];
            var fz:Number = points[5];
            var gx:Number = points[6];
            var gy:Number = points[7];
            var gz:Number = points[8];
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
            var offF:Number = x * fx + y * fy + z * fz;
            var offG:Number = x * gx + y * gy + z * gz;
            offF = offF < 0 ? -offF : offF;
            offG = offG < 0 ? -offG : offG;
            var distance:Number = low > 0 ? low : -high;
            distance -= offF + offG;
            var needed:Number = MARGINS * b.margin;
            if (distance > 0 && distance * distance > needed * needed * (x * x + y * y + z * z))
            {
                return BESIDE;
            }
            return first * second > 0 ? 2 : first * third > 0 ? 1 : 0;
        }

        // Returns which corner of b is alone on its side of a's plane; any one if none is.
        private static function cornerAcrossA(a:Vector.<Number>, at:int, b:ConvexShape):int
        {
            var points:Vector.<Number> = b.points;
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
            var second:Number = first + x * points[3] + y * points[4] + z * points[5];
            var third:Number = first + x * points[6] + y * points[7] + z * points[8];
            return first * second > 0 ? 2 : first * third > 0 ? 1 : 0;
        }

        // Whether a direction perpendicular to an edge of each keeps the triangles apart. The edges are those at a corner of each, counted from 0.
        private static function areEdgesApart(a:Vector.<Number>, at:int, cornerA:int, b:ConvexShape, cornerB:int):Boolean
        {
            var fromA:int = at + 3 * cornerA;
            var nextA:int = cornerA == 2 ? at : fromA + 3;
            var lastA:int = cornerA == 0 ? at + 6 : fromA - 3;
            var fromB:int = 3 * cornerB;
            var nextB:int = cornerB == 2 ? 0 : fromB + 3;
            var lastB:int = cornerB == 0 ? 6 : fromB - 3;
            return isApartAcross(a, fromA, nextA, lastA, b, fromB, nextB, lastB) || isApartAcross(a, fromA, nextA, lastA, b, fromB, lastB, nextB)
                || isApartAcross(a, fromA, lastA, nextA, b, fromB, lastB, nextB) || isApartAcross(a, fromA, lastA, nextA, b, fromB, nextB, lastB);
        }

        // Whether the direction perpendicular to an edge of each keeps the triangles apart: the edges u from fromA to toA, and f from fromB to toB. The
        // edges v and g go to the other corner of each. All corners are given as the indices of their first numbers.
        private static function isApartAcross(a:Vector.<Number>, fromA:int, toA:int, otherA:int, b:ConvexShape, fromB:int, toB:int, otherB:int):Boolean
        {
            var points:Vector.<Number> = b.points;
            var aX:Number = a[fromA];
            var aY:Number = a[int(fromA + 1)];
            var aZ:Number = a[int(fromA + 2)];
            var bX:Number = points[fromB];
            var bY:Number = points[int(fromB + 1)];
            var bZ:Number = points[int(fromB + 2)];
            var ux:Number = a[toA] - aX;
            var uy:Number = a[int(toA + 1)] - aY;
            var uz:Number = a[int(toA + 2)] - aZ;
            var fx:Number = points[toB] - bX;
            var fy:Number = points[int(toB + 1)] - bY;
            var fz:Number = points[int(toB + 2)] - bZ;
            var x:Number = uy * fz - uz * fy;
            var y:Number = uz * fx - ux * fz;
            var z:Number = ux * fy - uy * fx;
            var alongU:Number = x * ux + y * uy + z * uz;
            var alongV:Number = x * (a[otherA] - aX) + y * (a[int(otherA + 1)] - aY) + z * (a[int(otherA + 2)] - aZ);
            var low:Number = alongU < alongV ? alongU : alongV;
            var high:Number = alongU < alongV ? alongV : alongU;
            low = low < 0 ? low : 0;
            high = high > 0 ? high : 0;
            var alongF:Number = x * fx + y * fy + z * fz;
            var alongG:Number = x * (points[otherB] - bX) + y * (points[int(otherB + 1)] - bY) + z * (points[int(otherB + 2)] - bZ);
            var lowB:Number = alongF < alongG ? alongF : alongG;
            var highB:Number = alongF < alongG ? alongG : alongF;
            lowB = lowB < 0 ? lowB : 0;
            highB = highB > 0 ? highB : 0;
            var between:Number = x * (b.x - aX + bX) + y * (b.y - aY + bY) + z * (b.z - aZ + bZ);
            low -= between + highB;
            high -= between + lowB;
            var distance:Number = low > 0 ? low : -high;
            var needed:Number = MARGINS * b.margin;
            return distance > 0 && distance * distance > needed * needed * (x * x + y * y + z * z);
        }
    }
}
