package starlogo.fitting.minimal
{
    import flash.geom.Vector3D;
    import starlogo.fitting.EnclosingStructures;
    import starlogo.geometry.Tolerances;

    /**
     * The smallest ball with one to four given points on its surface. It is a part of SmallestEnclosingBall.
     *
     * @private
     */
    public final class CircumscribedBall
    {
        /** The centre. */
        public var center:Vector3D;

        /** The square of the radius. */
        public var squaredRadius:Number;

        /** The points, x, y, z of each. */
        public var points:Vector.<Number>;

        /**
         * Finds the ball of one to four points.
         *
         * @param points x, y, z of each
         * @return null if the points are not independent: four in a plane, three on a line, or two in one place
         */
        public static function through(points:Vector.<Number>):CircumscribedBall
        {
            // Each point after the first adds a direction that is perpendicular to the earlier ones (Gram and Schmidt). The centre moves
            // along it until the point is as far away as the first one.
            var axes:Vector.<Number> = new Vector.<Number>();
            var shiftX:Number = 0;
            var shiftY:Number = 0;
            var shiftZ:Number = 0;
            for (var i:int = 3; i < points.length; i += 3)
            {
                var toX:Number = points[i] - points[0];
                var toY:Number = points[i + 1] - points[1];
                var toZ:Number = points[i + 2] - points[2];
                var lengthSquared:Number = toX * toX + toY * toY + toZ * toZ;
                var missing:Number = lengthSquared / 2 - (toX * shiftX + toY * shiftY + toZ * shiftZ);
                for (var k:int = 0; k < axes.length; k += 3)
                {
                    var along:Number = toX * axes[k] + toY * axes[k + 1] + toZ * axes[k + 2];
                    toX -= along * axes[k];
                    toY -= along * axes[k + 1];
                    toZ -= along * axes[k + 2];
                }
                var length:Number = Math.sqrt(toX * toX + toY * toY + toZ * toZ);
                if (!(length * length > Tolerances.BALL_SINGULAR * lengthSquared))
                {
                    return null;
                }
                axes.push(toX / length, toY / length, toZ / length);
                shiftX += missing / length * (toX / length);
                shiftY += missing / length * (toY / length);
                shiftZ += missing / length * (toZ / length);
            }
            var ball:CircumscribedBall = new CircumscribedBall();
            ball.points = points;
            ball.center = new Vector3D(points[0] + shiftX, points[1] + shiftY, points[2] + shiftZ);
            ball.squaredRadius = shiftX * shiftX + shiftY * shiftY + shiftZ * shiftZ;
            return ball;
        }

        /** Whether the ball contains some points, x, y, z of each, except for rounding. */
        public function contains(others:Vector.<Number>):Boolean
        {
            for (var i:int = 0; i < others.length; i += 3)
            {
                if (EnclosingStructures.squaredDistance(others, i, center) > squaredRadius * (1 + Tolerances.BALL_SLACK))
                {
                    return false;
                }
            }
            return true;
        }
    }
}
