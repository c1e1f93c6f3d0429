package support
{
    import flash.geom.Vector3D;

    /**
     * The distance of two triangles, and of a triangle along a ray, by the formulas of textbooks: points, edges, crossings one after the other.
     * Of triangles without area, or nearly so, the edges count.
     */
    public final class PlainDistance
    {
        // height over longest edge
        private static const NEEDLE:Number = 1e-8;

        // the square of the sine of an angle
        private static const PARALLEL:Number = 1e-6;

        // the normal of a triangle, and whether it is too imprecise to use
        private static var sX:Number;
        private static var sY:Number;
        private static var sZ:Number;
        private static var sIsNeedle:Boolean;

        /** The distance of the nine numbers of a from the nine of b. */
        public static function between(a:Array, b:Array):Number
        {
            return ofTriangles(Vector.<Number>(a), 0, Vector.<Number>(b), 0);
        }

        /** The distance of nine numbers of one list from nine of another; triangles may be segments or points. */
        public static function ofTriangles(a:Vector.<Number>, atA:int, b:Vector.<Number>, atB:int):Number
        {
            var least:Number = Infinity;
            for (var i:int = 0; i < 3; i++)
            {
                var p:int = atA + 3 * i;
                var q:int = atA + 3 * ((i + 1) % 3);
                if (i > 0 && a[p] == a[q] && a[p + 1] == a[q + 1] && a[p + 2] == a[q + 2])
                {
                    // a point or a segment, so the edge before ends here
                    continue;
                }
                least = Math.min(least, ofPoint(a, p, b, atB), ofPoint(b, atB + 3 * i, a, atA));
                if (crosses(a, p, q, b, atB) || crosses(b, atB + 3 * i, atB + 3 * ((i + 1) % 3), a, atA))
                {
                    return 0;
                }
                for (var k:int = 0; k < 3; k++)
                {
                    least = Math.min(least, ofSegments(a, p, q, b, atB + 3 * k, atB + 3 * ((k + 1) % 3)));
                }
            }
            return least;
        }

        /** How far along a ray, whose direction is of length 1, a triangle is met; Infinity for never (Möller and Trumbore, 1997). */
        public static function alongRay(origin:Vector3D, direction:Vector3D, t:Vector.<Number>, at:int):Number
        {
            var a:Vector3D = new Vector3D(t[at], t[at + 1], t[at + 2]);
            var u:Vector3D = new Vector3D(t[at + 3], t[at + 4], t[at + 5]).subtract(a);
            var v:Vector3D = new Vector3D(t[at + 6], t[at + 7], t[at + 8]).subtract(a);
            var p:Vector3D = direction.crossProduct(v);
            var volume:Number = u.dotProduct(p);
            if (volume == 0)
            {
                return Infinity;
            }
            var from:Vector3D = origin.subtract(a);
            var first:Number = from.dotProduct(p) / volume;
            var q:Vector3D = from.crossProduct(u);
            var second:Number = direction.dotProduct(q) / volume;
            var along:Number = v.dotProduct(q) / volume;
            return first >= 0 && second >= 0 && first + second <= 1 && along >= 0 ? along : Infinity;
        }

        // Whether a segment passes through a triangle.
        private static function crosses(s:Vector.<Number>, p:int, q:int, t:Vector.<Number>, at:int):Boolean
        {
            normal(t, at);
            var x:Number = sX;
            var y:Number = sY;
            var z:Number = sZ;
            var atP:Number = x * (s[p] - t[at]) + y * (s[p + 1] - t[at + 1]) + z * (s[p + 2] - t[at + 2]);
            var atQ:Number = x * (s[q] - t[at]) + y * (s[q + 1] - t[at + 1]) + z * (s[q + 2] - t[at + 2]);
            if (!(atP * atQ < 0) || sIsNeedle)
            {
                return false;
            }
            var share:Number = atP / (atP - atQ);
            return isOver(s[p] + share * (s[q] - s[p]), s[p + 1] + share * (s[q + 1] - s[p + 1]), s[p + 2] + share * (s[q + 2] - s[p + 2]), t, at, x, y, z);
        }

        private static function normal(t:Vector.<Number>, at:int):void
        {
            var ux:Number = t[at + 3] - t[at];
            var uy:Number = t[at + 4] - t[at + 1];
            var uz:Number = t[at + 5] - t[at + 2];
            var vx:Number = t[at + 6] - t[at];
            var vy:Number = t[at + 7] - t[at + 1];
            var vz:Number = t[at + 8] - t[at + 2];
            sX = uy * vz - uz * vy;
            sY = uz * vx - ux * vz;
            sZ = ux * vy - uy * vx;
            var longest:Number = Math.max(lengthOf(ux, uy, uz), lengthOf(vx, vy, vz), lengthOf(ux - vx, uy - vy, uz - vz));
            sIsNeedle = !(lengthOf(sX, sY, sZ) > NEEDLE * longest * longest);
        }

        private static function isOver(px:Number, py:Number, pz:Number, t:Vector.<Number>, at:int, x:Number, y:Number, z:Number):Boolean
        {
            for (var i:int = 0; i < 3; i++)
            {
                var from:int = at + 3 * i;
                var to:int = at + 3 * ((i + 1) % 3);
                var ux:Number = t[to] - t[from];
                var uy:Number = t[to + 1] - t[from + 1];
                var uz:Number = t[to + 2] - t[from + 2];
                var vx:Number = px - t[from];
                var vy:Number = py - t[from + 1];
                var vz:Number = pz - t[from + 2];
                if (x * (uy * vz - uz * vy) + y * (uz * vx - ux * vz) + z * (ux * vy - uy * vx) < 0)
                {
                    return false;
                }
            }
            return true;
        }

        // Of a point from the face of a triangle; Infinity beside it, and for triangles without area.
        private static function ofPoint(s:Vector.<Number>, p:int, t:Vector.<Number>, at:int):Number
        {
            normal(t, at);
            var x:Number = sX;
            var y:Number = sY;
            var z:Number = sZ;
            if (sIsNeedle || !isOver(s[p], s[p + 1], s[p + 2], t, at, x, y, z))
            {
                return Infinity;
            }
            return Math.abs(x * (s[p] - t[at]) + y * (s[p + 1] - t[at + 1]) + z * (s[p + 2] - t[at + 2])) / lengthOf(x, y, z);
        }

        // Ericson, "Real-Time Collision Detection", 5.1.9. Of segments that are nearly parallel, or points, the least of the ends from the segments counts too.
        private static function ofSegments(a:Vector.<Number>, p:int, q:int, b:Vector.<Number>, r:int, s:int):Number
        {
            var ux:Number = a[q] - a[p];
            var uy:Number = a[q + 1] - a[p + 1];
            var uz:Number = a[q + 2] - a[p + 2];
            var vx:Number = b[s] - b[r];
            var vy:Number = b[s + 1] - b[r + 1];
            var vz:Number = b[s + 2] - b[r + 2];
            var wx:Number = a[p] - b[r];
            var wy:Number = a[p + 1] - b[r + 1];
            var wz:Number = a[p + 2] - b[r + 2];
            var uu:Number = ux * ux + uy * uy + uz * uz;
            var vv:Number = vx * vx + vy * vy + vz * vz;
            var uv:Number = ux * vx + uy * vy + uz * vz;
            var uw:Number = ux * wx + uy * wy + uz * wz;
            var vw:Number = vx * wx + vy * wy + vz * wz;
            var across:Number = uu * vv - uv * uv;
            var share:Number = across > 0 ? Math.max(0, Math.min(1, (uv * vw - uw * vv) / across)) : 0;
            var other:Number = vv > 0 ? Math.max(0, Math.min(1, (uv * share + vw) / vv)) : 0;
            share = uu > 0 ? Math.max(0, Math.min(1, (uv * other - uw) / uu)) : 0;
            var least:Number = lengthOf(wx + share * ux - other * vx, wy + share * uy - other * vy, wz + share * uz - other * vz);
            if (!(across > PARALLEL * uu * vv))
            {
                least = Math.min(least, fromSegment(a, p, b, r, s), fromSegment(a, q, b, r, s), fromSegment(b, r, a, p, q), fromSegment(b, s, a, p, q));
            }
            return least;
        }

        private static function fromSegment(a:Vector.<Number>, p:int, b:Vector.<Number>, r:int, s:int):Number
        {
            var ux:Number = b[s] - b[r];
            var uy:Number = b[s + 1] - b[r + 1];
            var uz:Number = b[s + 2] - b[r + 2];
            var wx:Number = a[p] - b[r];
            var wy:Number = a[p + 1] - b[r + 1];
            var wz:Number = a[p + 2] - b[r + 2];
            var squared:Number = ux * ux + uy * uy + uz * uz;
            var t:Number = squared > 0 ? Math.max(0, Math.min(1, (wx * ux + wy * uy + wz * uz) / squared)) : 0;
            return lengthOf(wx - t * ux, wy - t * uy, wz - t * uz);
        }

        private static function lengthOf(x:Number, y:Number, z:Number):Number
        {
            return Math.sqrt(x * x + y * y + z * z);
        }
    }
}
