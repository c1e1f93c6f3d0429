package support
{
    /** The smallest sphere of a few points by trying every sphere on two, three or four of them. */
    public final class SmallestSphereReference
    {
        /** Its radius. */
        public static function radius(points:Vector.<Number>):Number
        {
            var count:int = points.length / 3;
            var least:Number = count == 1 ? 0 : Infinity;
            for (var a:int = 0; a < count; a++)
            {
                for (var b:int = 0; b <= a; b++)
                {
                    for (var c:int = 0; c <= b; c++)
                    {
                        for (var d:int = 0; d <= c; d++)
                        {
                            // points that repeat make it a sphere on fewer
                            least = Math.min(least, radiusOn(points, [a, b, c, d]));
                        }
                    }
                }
            }
            return least;
        }

        // The smallest sphere through these, if it holds all points: its centre is where the distances to the first and each
        // other are equal, in the plane or line that they span (by Gram and Schmidt).
        private static function radiusOn(points:Vector.<Number>, chosen:Array):Number
        {
            var origin:Array = at(points, chosen[0]);
            var center:Array = origin.concat();
            var basis:Array = [];
            for (var i:int = 1; i < 4; i++)
            {
                var other:Array = at(points, chosen[i]);
                var direction:Array = minus(other, origin);
                for each (var unit:Array in basis)
                {
                    direction = minus(direction, times(unit, dot(direction, unit)));
                }
                var length:Number = Math.sqrt(dot(direction, direction));
                if (length < 1e-9)
                {
                    continue;
                }
                direction = times(direction, 1 / length);
                basis.push(direction);
                // along the new direction until this point is as far as the first
                var toOther:Array = minus(other, center);
                var toFirst:Array = minus(origin, center);
                var shift:Number = (dot(toOther, toOther) - dot(toFirst, toFirst)) / (2 * (dot(toOther, direction) - dot(toFirst, direction)));
                center = minus(center, times(direction, -shift));
            }
            var square:Number = dot(minus(origin, center), minus(origin, center));
            for (i = 0; i < points.length / 3; i++)
            {
                var to:Array = minus(at(points, i), center);
                if (Math.sqrt(dot(to, to)) > Math.sqrt(square) + 1e-10)
                {
                    return Infinity;
                }
            }
            return Math.sqrt(square);
        }

        private static function at(points:Vector.<Number>, i:int):Array
        {
            return [points[3 * i], points[3 * i + 1], points[3 * i + 2]];
        }

        private static function minus(a:Array, b:Array):Array
        {
            return [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
        }

        private static function times(a:Array, factor:Number):Array
        {
            return [a[0] * factor, a[1] * factor, a[2] * factor];
        }

        private static function dot(a:Array, b:Array):Number
        {
            return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
        }
    }
}
