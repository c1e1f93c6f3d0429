package support
{
    /**
     * The distance of two triangles, the slow and plain way: 0 where an edge of one passes through the other, otherwise the
     * least of every edge from every edge and every corner from the other triangle. Of triangles without area, or
     * nearly so, the edges count.
     */
    public final class TriangleDistance
    {
        // height over longest edge
        private static const NEEDLE:Number = 1e-8;

        /** The distance of the nine numbers of a from the nine of b. */
        public static function between(a:Array, b:Array):Number
        {
            var least:Number = Infinity;
            for (var i:int = 0; i < 3; i++)
            {
                if (passesThrough(corner(a, i), corner(a, i + 1), b) || passesThrough(corner(b, i), corner(b, i + 1), a))
                {
                    return 0;
                }
                least = Math.min(least, fromPoint(corner(a, i), b), fromPoint(corner(b, i), a));
                for (var j:int = 0; j < 3; j++)
                {
                    least = Math.min(least, ofSegments(corner(a, i), corner(a, i + 1), corner(b, j), corner(b, j + 1)));
                }
            }
            return least;
        }

        private static function passesThrough(p:Array, q:Array, triangle:Array):Boolean
        {
            var a:Array = corner(triangle, 0);
            var n:Array = cross(minus(corner(triangle, 1), a), minus(corner(triangle, 2), a));
            var atP:Number = dot(n, minus(p, a));
            var atQ:Number = dot(n, minus(q, a));
            if (atP * atQ >= 0 || isNeedle(triangle, n))
            {
                return false;
            }
            return isOver(at(p, q, atP / (atP - atQ)), triangle, n);
        }

        // Whether everything on a triangle is nearly on an edge: its normal is imprecise.
        private static function isNeedle(triangle:Array, n:Array):Boolean
        {
            var longest:Number = 0;
            for (var i:int = 0; i < 3; i++)
            {
                var edge:Array = minus(corner(triangle, i + 1), corner(triangle, i));
                longest = Math.max(longest, dot(edge, edge));
            }
            return dot(n, n) <= NEEDLE * NEEDLE * longest * longest;
        }

        // Whether a point's foot on the plane is in the triangle.
        private static function isOver(p:Array, triangle:Array, n:Array):Boolean
        {
            for (var i:int = 0; i < 3; i++)
            {
                var a:Array = corner(triangle, i);
                if (dot(cross(minus(corner(triangle, i + 1), a), minus(p, a)), n) < 0)
                {
                    return false;
                }
            }
            return true;
        }

        private static function fromPoint(p:Array, triangle:Array):Number
        {
            var a:Array = corner(triangle, 0);
            var n:Array = cross(minus(corner(triangle, 1), a), minus(corner(triangle, 2), a));
            var length:Number = Math.sqrt(dot(n, n));
            return !isNeedle(triangle, n) && isOver(p, triangle, n) ? Math.abs(dot(n, minus(p, a))) / length : Infinity;
        }

        // The least of the ends from the segments, and of the lines where their nearest points are on both.
        private static function ofSegments(p:Array, q:Array, r:Array, s:Array):Number
        {
            var least:Number = Math.min(fromSegment(p, r, s), fromSegment(q, r, s), fromSegment(r, p, q), fromSegment(s, p, q));
            var u:Array = minus(q, p);
            var v:Array = minus(s, r);
            var n:Array = cross(u, v);
            var squared:Number = dot(n, n);
            if (squared > 0)
            {
                var w:Array = minus(r, p);
                var t:Number = dot(cross(w, v), n) / squared;
                var k:Number = dot(cross(w, u), n) / squared;
                if (t >= 0 && t <= 1 && k >= 0 && k <= 1)
                {
                    var between:Array = minus(at(p, q, t), at(r, s, k));
                    least = Math.min(least, Math.sqrt(dot(between, between)));
                }
            }
            return least;
        }

        private static function fromSegment(p:Array, a:Array, b:Array):Number
        {
            var u:Array = minus(b, a);
            var squared:Number = dot(u, u);
            var t:Number = squared > 0 ? Math.max(0, Math.min(1, dot(minus(p, a), u) / squared)) : 0;
            var between:Array = minus(p, at(a, b, t));
            return Math.sqrt(dot(between, between));
        }

        private static function corner(triangle:Array, i:int):Array
        {
            return triangle.slice(3 * (i % 3), 3 * (i % 3) + 3);
        }

        private static function at(a:Array, b:Array, t:Number):Array
        {
            return [a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2])];
        }

        private static function minus(a:Array, b:Array):Array
        {
            return [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
        }

        private static function dot(a:Array, b:Array):Number
        {
            return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
        }

        private static function cross(a:Array, b:Array):Array
        {
            return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
        }
    }
}
