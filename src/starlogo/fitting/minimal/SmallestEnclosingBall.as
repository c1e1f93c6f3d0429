package starlogo.fitting.minimal
{
    import starlogo.geometry.Tolerances;

    /**
     * The smallest ball around points, exactly: the one through at most four of them that holds all (Welzl, "Smallest
     * Enclosing Disks (Balls and Ellipsoids)", 1991).
     *
     * <p>It grows from a single point: the point farthest outside joins, with Gaertner's pivot rule ("Fast and Robust Smallest
     * Enclosing Balls", ESA 1999), and the smallest ball around the points that held the ball so far and this one takes its
     * place. There are at most fifteen to choose from, each through a few points: those are tried one by one, which no
     * degenerate position of the points can lead astray. The ball only grows, so it ends; usually after five to fifteen
     * passes over the points. With z = 0 throughout it finds the smallest circle.</p>
     */
    public final class SmallestEnclosingBall
    {
        // Everything below is seen from the first point: far from the origin nothing is lost to rounding.
        private var _originX:Number;
        private var _originY:Number;
        private var _originZ:Number;

        private var _x:Number = 0;
        private var _y:Number = 0;
        private var _z:Number = 0;
        private var _square:Number = 0;
        private var _held:Vector.<Number> = new <Number>[0, 0, 0];

        // the ball through the points chosen last
        private var _tryX:Number;
        private var _tryY:Number;
        private var _tryZ:Number;
        private var _trySquare:Number;

        /**
         * @param points x, y, z each, at least one
         */
        public function SmallestEnclosingBall(points:Vector.<Number>)
        {
            _originX = points[0];
            _originY = points[1];
            _originZ = points[2];
            enclose(points);
        }

        /** The centre. */
        public function get x():Number
        {
            return _originX + _x;
        }

        /** @copy #x */
        public function get y():Number
        {
            return _originY + _y;
        }

        /** @copy #x */
        public function get z():Number
        {
            return _originZ + _z;
        }

        /** The radius. */
        public function get radius():Number
        {
            return Math.sqrt(_square);
        }

        /**
         * Grows to the smallest ball around these points and those that it had to hold before.
         *
         * @param points x, y, z each
         */
        public function enclose(points:Vector.<Number>):void
        {
            var grows:Boolean = true;
            while (grows)
            {
                var i:int = farthest(points);
                var toX:Number = points[i] - _originX;
                var toY:Number = points[i + 1] - _originY;
                var toZ:Number = points[i + 2] - _originZ;
                grows = squareFrom(toX, toY, toZ) > _square * (1 + Tolerances.BALL_GAIN) && hold(toX, toY, toZ);
            }
        }

        private function farthest(points:Vector.<Number>):int
        {
            var result:int = 0;
            var most:Number = -1;
            var centerX:Number = _originX + _x;
            var centerY:Number = _originY + _y;
            var centerZ:Number = _originZ + _z;
            var length:int = points.length;
            for (var i:int = 0; i < length; i += 3)
            {
                var toX:Number = points[i] - centerX;
                var toY:Number = points[i + 1] - centerY;
                var toZ:Number = points[i + 2] - centerZ;
                var square:Number = toX * toX + toY * toY + toZ * toZ;
                if (square > most)
                {
                    most = square;
                    result = i;
                }
            }
            return result;
        }

        private function squareFrom(pointX:Number, pointY:Number, pointZ:Number):Number
        {
            pointX -= _x;
            pointY -= _y;
            pointZ -= _z;
            return pointX * pointX + pointY * pointY + pointZ * pointZ;
        }

        // The smallest ball around the points held and this one, through this one; false if it does not grow any more.
        private function hold(pointX:Number, pointY:Number, pointZ:Number):Boolean
        {
            var all:Vector.<Number> = _held.concat(new <Number>[pointX, pointY, pointZ]);
            var others:int = _held.length / 3;
            var least:Number = Infinity;
            var bestX:Number;
            var bestY:Number;
            var bestZ:Number;
            var best:Vector.<Number> = null;
            for (var subset:int = 0; subset < 1 << others; subset++)
            {
                var chosen:Vector.<Number> = choose(all, others, subset);
                if (chosen.length <= 12 && passThrough(chosen) && _trySquare < least && holds(all))
                {
                    least = _trySquare;
                    bestX = _tryX;
                    bestY = _tryY;
                    bestZ = _tryZ;
                    best = chosen;
                }
            }
            if (best == null || least <= _square * (1 + Tolerances.BALL_GAIN))
            {
                return false;
            }
            _x = bestX;
            _y = bestY;
            _z = bestZ;
            _square = least;
            _held = best;
            return true;
        }

        // The last point, and those of the others whose bits are set.
        private static function choose(all:Vector.<Number>, others:int, subset:int):Vector.<Number>
        {
            var chosen:Vector.<Number> = new <Number>[all[3 * others], all[3 * others + 1], all[3 * others + 2]];
            for (var i:int = 0; i < others; i++)
            {
                if ((subset >> i & 1) == 1)
                {
                    chosen.push(all[3 * i], all[3 * i + 1], all[3 * i + 2]);
                }
            }
            return chosen;
        }

        private function holds(points:Vector.<Number>):Boolean
        {
            for (var i:int = 0; i < points.length; i += 3)
            {
                var toX:Number = points[i] - _tryX;
                var toY:Number = points[i + 1] - _tryY;
                var toZ:Number = points[i + 2] - _tryZ;
                if (toX * toX + toY * toY + toZ * toZ > _trySquare * (1 + Tolerances.BALL_SLACK))
                {
                    return false;
                }
            }
            return true;
        }

        // The smallest ball with one to four points on its surface: its centre is q0 + l1 (q1 - q0) + ..., where G l = diag(G) / 2
        // and G holds the dot products of the differences. Solved by elimination, the largest diagonal first.
        private function passThrough(q:Vector.<Number>):Boolean
        {
            var n:int = q.length / 3 - 1;
            var d:Vector.<Number> = new Vector.<Number>(3 * n);
            var i:int;
            var j:int;
            var k:int;
            for (i = 0; i < 3 * n; i++)
            {
                d[i] = q[i + 3] - q[i % 3];
            }
            var width:int = n + 1;
            var g:Vector.<Number> = new Vector.<Number>(n * width);
            for (i = 0; i < n; i++)
            {
                for (j = 0; j < n; j++)
                {
                    g[i * width + j] = d[3 * i] * d[3 * j] + d[3 * i + 1] * d[3 * j + 1] + d[3 * i + 2] * d[3 * j + 2];
                }
                g[i * width + n] = g[i * width + i] / 2;
            }
            var weights:Vector.<Number> = solve(g, n);
            if (weights == null)
            {
                return false;
            }
            var shiftX:Number = 0;
            var shiftY:Number = 0;
            var shiftZ:Number = 0;
            for (k = 0; k < n; k++)
            {
                shiftX += weights[k] * d[3 * k];
                shiftY += weights[k] * d[3 * k + 1];
                shiftZ += weights[k] * d[3 * k + 2];
            }
            _tryX = q[0] + shiftX;
            _tryY = q[1] + shiftY;
            _tryZ = q[2] + shiftZ;
            _trySquare = shiftX * shiftX + shiftY * shiftY + shiftZ * shiftZ;
            return true;
        }

        // A symmetric system of n equations, n + 1 numbers each; null when it is singular.
        private static function solve(g:Vector.<Number>, n:int):Vector.<Number>
        {
            var width:int = n + 1;
            var row:int;
            var column:int;
            var pivots:Vector.<int> = new Vector.<int>(n);
            var scales:Vector.<Number> = new Vector.<Number>(n);
            for (row = 0; row < n; row++)
            {
                scales[row] = g[row * width + row];
                pivots[row] = -1;
            }
            for (var step:int = 0; step < n; step++)
            {
                var pivot:int = -1;
                for (row = 0; row < n; row++)
                {
                    if (pivots[row] < 0 && (pivot < 0 || g[row * width + row] > g[pivot * width + pivot]))
                    {
                        pivot = row;
                    }
                }
                if (!(g[pivot * width + pivot] > Tolerances.BALL_SINGULAR * scales[pivot]))
                {
                    return null;
                }
                pivots[pivot] = step;
                for (row = 0; row < n; row++)
                {
                    if (row == pivot)
                    {
                        continue;
                    }
                    var factor:Number = g[row * width + pivot] / g[pivot * width + pivot];
                    for (column = 0; column < width; column++)
                    {
                        g[row * width + column] -= factor * g[pivot * width + column];
                    }
                }
            }
            var solution:Vector.<Number> = new Vector.<Number>(n);
            for (row = 0; row < n; row++)
            {
                solution[row] = g[row * width + n] / g[row * width + row];
            }
            return solution;
        }
    }
}
