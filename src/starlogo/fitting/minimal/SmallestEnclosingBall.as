package starlogo.fitting.minimal
{
    import flash.geom.Vector3D;
    import starlogo.fitting.EnclosingStructures;
    import starlogo.geometry.Tolerances;

    /**
     * Finds the smallest ball around points, exactly (Welzl, "Smallest Enclosing Disks (Balls and Ellipsoids)", 1991). At most four points
     * on its surface determine it. With z = 0 for all points it finds the smallest circle.
     *
     * <p>The ball grows from a single point. In each round the point that is farthest outside joins, by Gaertner's pivot rule ("Fast and
     * Robust Smallest Enclosing Balls", ESA 1999). The next ball is the smallest one around this point and the points that determined the
     * ball so far. At most fifteen balls are possible, each through a few points. They are tried one by one, so degenerate positions of the
     * points do no harm. The ball only grows, so the search ends, usually after five to fifteen passes over the points.</p>
     *
     * @private
     */
    public final class SmallestEnclosingBall
    {
        // The ball so far, relative to the first point, because rounding would lose digits far from the origin.
        private var _origin:Vector.<Number>;
        private var _ball:CircumscribedBall = CircumscribedBall.through(new <Number>[0, 0, 0]);

        /**
         * @param points x, y, z of each, at least one
         */
        public function SmallestEnclosingBall(points:Vector.<Number>)
        {
            _origin = points.slice(0, 3);
            enclose(points);
        }

        /** The centre. */
        public function get center():Vector3D
        {
            return new Vector3D(_origin[0] + _ball.center.x, _origin[1] + _ball.center.y, _origin[2] + _ball.center.z);
        }

        /** The radius. */
        public function get radius():Number
        {
            return Math.sqrt(_ball.squaredRadius);
        }

        /**
         * Grows to the smallest ball around these points.
         *
         * @param points x, y, z of each. They must include the points of earlier calls, because the ball keeps only those that determine it
         */
        public function enclose(points:Vector.<Number>):void
        {
            var grows:Boolean = true;
            while (grows)
            {
                var i:int = EnclosingStructures.farthest(points, center);
                var point:Vector.<Number> = new <Number>[points[i] - _origin[0], points[i + 1] - _origin[1], points[i + 2] - _origin[2]];
                grows = isLarger(EnclosingStructures.squaredDistance(point, 0, _ball.center)) && growTo(point);
            }
        }

        private function isLarger(square:Number):Boolean
        {
            return square > _ball.squaredRadius * (1 + Tolerances.BALL_GAIN);
        }

        // Grows to the smallest ball through this point and around the points of the ball so far. Returns whether it has grown by
        // more than rounding. If not, its centre may have moved all the same: as far as a point is from a ball that is hardly too small.
        private function growTo(point:Vector.<Number>):Boolean
        {
            var earlier:Vector.<Number> = _ball.points;
            var all:Vector.<Number> = earlier.concat(point);
            var others:int = earlier.length / 3;
            var best:CircumscribedBall = null;
            for (var subset:int = 0; subset < 1 << others; subset++)
            {
                var chosen:Vector.<Number> = point.concat();
                for (var i:int = 0; i < others; i++)
                {
                    if ((subset >> i & 1) == 1)
                    {
                        chosen.push(earlier[3 * i], earlier[3 * i + 1], earlier[3 * i + 2]);
                    }
                }
                var ball:CircumscribedBall = chosen.length > 12 ? null : CircumscribedBall.through(chosen);
                if (ball != null && (best == null || ball.squaredRadius < best.squaredRadius) && ball.contains(all))
                {
                    best = ball;
                }
            }
            if (best == null || best.squaredRadius < _ball.squaredRadius)
            {
                return false;
            }
            var grows:Boolean = isLarger(best.squaredRadius);
            _ball = best;
            return grows;
        }
    }
}
