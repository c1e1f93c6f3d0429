package starlogo.intersection
{
    import starlogo.convex.ConvexShape;

    /**
     * A quick test that rules out most pairs of triangles: whether a direction is known along which the two are farther apart than they may be to
     * touch. If it is false, the triangles may still be apart, and ConvexPair has to decide. Allocates nothing.
     *
     * <p>The directions are the second triangle's normal, and those perpendicular to an edge of each. If each triangle crosses the other's plane,
     * each has one corner alone on its side of that plane. Then only the edges from these two corners can face each other (Guigue and Devillers,
     * "Fast and robust triangle-triangle overlap test using orientation predicates", Journal of Graphics Tools, 2003).</p>
     *
     * @param a nine numbers of the first triangle: x, y, z of each corner
     * @param at index of the first of them in a
     * @param b the second triangle, in the same space. Its margin must be larger than rounding errors, and at least Tolerances.SURFACES of the
     *     coordinates' size
     * @private
     */
    public function areTrianglesApart(a:Vector.<Number>, at:int, b:ConvexShape):Boolean
    {
        // ConvexPair adds Tolerances.CORES to the gap, which is less than half of Tolerances.SURFACES
        var limit:Number = 1.5 * b.margin;
        limit *= limit;

        // The vectors u and v are a's edges from its first corner, f and g are b's edges from its first corner, and d connects the two
        // corners.
        var p:Vector.<Number> = b.points;
        var x:Number = a[at];
        var y:Number = a[int(at + 1)];
        var z:Number = a[int(at + 2)];
        var ux:Number = a[int(at + 3)] - x;
        var uy:Number = a[int(at + 4)] - y;
        var uz:Number = a[int(at + 5)] - z;
        var vx:Number = a[int(at + 6)] - x;
        var vy:Number = a[int(at + 7)] - y;
        var vz:Number = a[int(at + 8)] - z;
        var dx:Number = b.x - x;
        var dy:Number = b.y - y;
        var dz:Number = b.z - z;
        var fx:Number = p[3];
        var fy:Number = p[4];
        var fz:Number = p[5];
        var gx:Number = p[6];
        var gy:Number = p[7];
        var gz:Number = p[8];

        // Whether all of a is on one side of b's plane.
        x = fy * gz - fz * gy;
        y = fz * gx - fx * gz;
        z = fx * gy - fy * gx;
        var atFirst:Number = -x * dx - y * dy - z * dz;
        var atU:Number = atFirst + x * ux + y * uy + z * uz;
        var atV:Number = atFirst + x * vx + y * vy + z * vz;
        var low:Number = atU < atV ? atU : atV;
        var high:Number = atU < atV ? atV : atU;
        low = atFirst < low ? atFirst : low;
        high = atFirst < high ? high : atFirst;
        // For a needle, b's own corners are off the plane that was computed.
        var own:Number = x * fx + y * fy + z * fz;
        var gap:Number = own < 0 ? own : -own;
        own = x * gx + y * gy + z * gz;
        own = own < 0 ? own : -own;
        gap += own;
        own = low > 0 ? low : -high;
        gap += own;
        if (gap > 0 && gap * gap > limit * (x * x + y * y + z * z))
        {
            return true;
        }

        // Now u and v begin at the corner that is alone on its side of b's plane.
        if (atFirst * atU > 0)
        {
            dx -= vx;
            dy -= vy;
            dz -= vz;
            ux -= vx;
            uy -= vy;
            uz -= vz;
            vx = -vx;
            vy = -vy;
            vz = -vz;
        }
        else if (atFirst * atV > 0)
        {
            dx -= ux;
            dy -= uy;
            dz -= uz;
            vx -= ux;
            vy -= uy;
            vz -= uz;
            ux = -ux;
            uy = -uy;
            uz = -uz;
        }

        // Now f and g begin at the corner that is alone on its side of a's plane.
        x = uy * vz - uz * vy;
        y = uz * vx - ux * vz;
        z = ux * vy - uy * vx;
        atFirst = x * dx + y * dy + z * dz;
        atU = atFirst + x * fx + y * fy + z * fz;
        atV = atFirst + x * gx + y * gy + z * gz;
        if (atFirst * atU > 0)
        {
            dx += gx;
            dy += gy;
            dz += gz;
            fx -= gx;
            fy -= gy;
            fz -= gz;
            gx = -gx;
            gy = -gy;
            gz = -gz;
        }
        else if (atFirst * atV > 0)
        {
            dx += fx;
            dy += fy;
            dz += fz;
            gx -= fx;
            gy -= fy;
            gz -= fz;
            fx = -fx;
            fy = -fy;
            fz = -fz;
        }

        // The axes perpendicular to an edge of each: u and f, u and g, v and g, v and f.
        for (var i:int = 0; i < 4; i++)
        {
            x = uy * fz - uz * fy;
            y = uz * fx - ux * fz;
            z = ux * fy - uy * fx;
            atU = x * ux + y * uy + z * uz;
            atV = x * vx + y * vy + z * vz;
            low = atU < atV ? atU : atV;
            high = atU < atV ? atV : atU;
            low = low < 0 ? low : 0;
            high = high > 0 ? high : 0;
            atFirst = x * dx + y * dy + z * dz;
            atU = x * fx + y * fy + z * fz;
            atV = x * gx + y * gy + z * gz;
            var lowB:Number = atU < atV ? atU : atV;
            var highB:Number = atU < atV ? atV : atU;
            lowB = lowB < 0 ? lowB : 0;
            highB = highB > 0 ? highB : 0;
            low -= atFirst + highB;
            high -= atFirst + lowB;
            gap = low > 0 ? low : -high;
            if (gap > 0 && gap * gap > limit * (x * x + y * y + z * z))
            {
                return true;
            }
            if (i == 1)
            {
                x = ux;
                y = uy;
                z = uz;
                ux = vx;
                uy = vy;
                uz = vz;
                vx = x;
                vy = y;
                vz = z;
            }
            else
            {
                x = fx;
                y = fy;
                z = fz;
                fx = gx;
                fy = gy;
                fz = gz;
                gx = x;
                gy = y;
                gz = z;
            }
        }
        return false;
    }
}
