package starlogo.fitting.minimal
{
    import starlogo.geometry.Tolerances;

    /**
     * The smallest ball with one to four points on its surface: a part of SmallestEnclosingBall.
     *
     * @private
     */
    public final class CircumscribedBall
    {
        /** The centre. */
        public var x:Number;

        /** @copy #x */
        public var y:Number;

        /** @copy #x */
        public var z:Number;

        /** The square of the radius. */
        public var square:Number;

        /** The points, x, y, z each. */
        public var points:Vector.<Number>;

        /** Made by through(). */
        public function CircumscribedBall()
        {
        }

        /**
         * The ball of some points.
         *
         * @param points x, y, z each
         * @return null if they are not independent: of four in a plane, three on a line, or two in a point
         */
        public static function through(points:Vector.<Number>):CircumscribedBall
        {
            // the centre is q0 + l1 (q1 - q0) + ..., where G l = diag(G) / 2 and G holds the dot products of the differences
            var n:int = points.length / 3 - 1;
            var width:int = n + 1;
            var d:Vector.<Number> = new Vector.<Number>(3 * n);
            var i:int;
            for (i = 0; i < 3 * n; i++)
            {
                d[i] = points[i + 3] - points[i % 3];
            }
            var g:Vector.<Number> = new Vector.<Number>(n * width);
            for (i = 0; i < n; i++)
            {
                for (var j:int = 0; j < n; j++)
                {
                    g[i * width + j] = d[3 * i] * d[3 * j] + d[3 * i + 1] * d[3 * j + 1] + d[3 * i + 2] * d[3 * j + 2];
                }
                g[i * width + n] = g[i * width + i] / 2;
            }
            if (!eliminate(g, n))
            {
                return null;
            }
            var shiftX:Number = 0;
            var shiftY:Number = 0;
            var shiftZ:Number = 0;
            for (i = 0; i < n; i++)
            {
                var weight:Number = g[i * width + n] / g[i * width + i];
                shiftX += weight * d[3 * i];
                shiftY += weight * d[3 * i + 1];
                shiftZ += weight * d[3 * i + 2];
            }
            var ball:CircumscribedBall = new CircumscribedBall();
            ball.points = points;
            ball.x = points[0] + shiftX;
            ball.y = points[1] + shiftY;
            ball.z = points[2] + shiftZ;
            ball.square = shiftX * shiftX + shiftY * shiftY + shiftZ * shiftZ;
            return ball;
        }

        /** The square of a point's distance from the centre. */
        public function squareTo(pointX:Number, pointY:Number, pointZ:Number):Number
        {
            pointX -= x;
            pointY -= y;
            pointZ -= z;
            return pointX * pointX + pointY * pointY + pointZ * pointZ;
        }

        /** Whether the ball holds some points, x, y, z each, but for rounding. */
        public function holds(others:Vector.<Number>):Boolean
        {
            for (var i:int = 0; i < others.length; i += 3)
            {
                if (squareTo(others[i], others[i + 1], others[i + 2]) > square * (1 + Tolerances.BALL_SLACK))
                {
                    return false;
                }
            }
            return true;
        }

        // Solves a symmetric system of n equations, n + 1 numbers each, by elimination, the largest diagonal first; false when it is
        // singular.
        private static function eliminate(g:Vector.<Number>, n:int):Boolean
        {
            var width:int = n + 1;
            var row:int;
            var isDone:Vector.<Boolean> = new Vector.<Boolean>(n);
            var scales:Vector.<Number> = new Vector.<Number>(n);
            for (row = 0; row < n; row++)
            {
                scales[row] = g[row * width + row];
            }
            for (var step:int = 0; step < n; step++)
            {
                var pivot:int = -1;
                for (row = 0; row < n; row++)
                {
                    if (!isDone[row] && (pivot < 0 || g[row * width + row] > g[pivot * width + pivot]))
                    {
                        pivot = row;
                    }
                }
                if (!(g[pivot * width + pivot] > Tolerances.BALL_SINGULAR * scales[pivot]))
                {
                    return false;
                }
                isDone[pivot] = true;
                for (row = 0; row < n; row++)
                {
                    var factor:Number = g[row * width + pivot] / g[pivot * width + pivot];
                    for (var column:int = 0; column < width && row != pivot; column++)
                    {
                        g[row * width + column] -= factor * g[pivot * width + column];
                    }
                }
            }
            return true;
        }
    }
}
