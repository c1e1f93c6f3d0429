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
     *
     * @private
     */
    public final class SmallestEnclosingBall
    {
        // The ball so far, seen from the first point: far from the origin nothing is lost to rounding.
        private var _originX:Number;
        private var _originY:Number;
        private var _originZ:Number;
        private var _ball:CircumscribedBall = CircumscribedBall.through(new <Number>[0, 0, 0]);

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
            return _originX + _ball.x;
        }

        /** @copy #x */
        public function get y():Number
        {
            return _originY + _ball.y;
        }

        /** @copy #x */
        public function get z():Number
        {
            return _originZ + _ball.z;
        }

        /** The radius. */
        public function get radius():Number
        {
            return Math.sqrt(_ball.square);
        }

        /**
         * Grows to the smallest ball around these points and all those before.
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
                grows = isLarger(_ball.squareTo(toX, toY, toZ)) && hold(toX, toY, toZ);
            }
        }

        private function isLarger(square:Number):Boolean
        {
            return square > _ball.square * (1 + Tolerances.BALL_GAIN);
        }

        private function farthest(points:Vector.<Number>):int
        {
            var result:int = 0;
            var most:Number = -1;
            var centerX:Number = x;
            var centerY:Number = y;
            var centerZ:Number = z;
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

        // The smallest ball around the points held and this one, through this one; false if it does not grow any more.
        private function hold(pointX:Number, pointY:Number, pointZ:Number):Boolean
        {
            var held:Vector.<Number> = _ball.points;
            var all:Vector.<Number> = held.concat(new <Number>[pointX, pointY, pointZ]);
            var others:int = held.length / 3;
            var best:CircumscribedBall = null;
            for (var subset:int = 0; subset < 1 << others; subset++)
            {
                var chosen:Vector.<Number> = new <Number>[pointX, pointY, pointZ];
                for (var i:int = 0; i < others; i++)
                {
                    if ((subset >> i & 1) == 1)
                    {
                        chosen.push(held[3 * i], held[3 * i + 1], held[3 * i + 2]);
                    }
                }
                var ball:CircumscribedBall = chosen.length > 12 ? null : CircumscribedBall.through(chosen);
                if (ball != null && (best == null || ball.square < best.square) && ball.holds(all))
                {
                    best = ball;
                }
            }
            if (best == null || !isLarger(best.square))
            {
                return false;
            }
            _ball = best;
            return true;
        }
    }
}
