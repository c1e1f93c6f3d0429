package starlogo.intersection.sweep
{
    /** Newton's method on the distance of two convex structures that near each other along a straight way. */
    internal final class Newton
    {
        /**
         * More steps than it can take: the product of the gap and its slope shrinks to a quarter in each, and both are numbers with
         * 53 bits.
         */
        public static const MOST_STEPS:int = 80;

        /** It has no state; there are no instances. */
        public function Newton()
        {
        }

        /**
         * The time before which the structures do not touch: where the plane between the points nearest to each other, moved along, has
         * no gap left.
         *
         * @param time now
         * @param squared the squared distance of the cores, more than 0
         * @param radii the distance at which they touch
         * @param closing the way towards each other along the line between the nearest points, times their distance
         * @return RelativeMotion.NEVER if they do not come nearer
         */
        public static function next(time:Number, squared:Number, radii:Number, closing:Number):Number
        {
            if (!(closing > 0))
            {
                return RelativeMotion.NEVER;
            }
            var distance:Number = Math.sqrt(squared);
            return time + (distance - radii) * distance / closing;
        }

        /**
         * The time of a touch, once the distance is so near to the radii that the rest is rounding: one more step, which rounding may
         * have spared. Who touches at time 0 does so at time 0.
         *
         * @param reach the square of what is so near
         */
        public static function lastStep(time:Number, squared:Number, reach:Number, radii:Number, closing:Number):Number
        {
            var rounding:Number = Math.sqrt(reach) - radii;
            // cores that touch themselves have no direction from one to the other
            if (time == 0 || squared <= radii * radii || squared <= rounding * rounding)
            {
                return time;
            }
            var last:Number = next(time, squared, radii, closing);
            return last <= 1 ? last : time;
        }
    }
}
