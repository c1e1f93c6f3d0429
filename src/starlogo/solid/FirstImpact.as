package starlogo.solid
{
    import flash.geom.Vector3D;
    import starlogo.convex.RelativeMotion;
    import starlogo.convex.TrianglePlane;
    import starlogo.geometry.Tolerances;

    /**
     * Chooses the triangle, or the pair of triangles, that makes the contact of an impact: the one that is touched first. Of those that are touched at
     * the same time (Tolerances.SAME_TIME), it is the one whose plane the motion meets most squarely. So a shape that moves along a side, flush with it,
     * and then meets another side, touches the one that stops it.
     *
     * <p>What touches at time 0 ends the search: the first one found makes the contact, because nothing is earlier. The way out of an overlap is
     * another search.</p>
     *
     * @private
     */
    public final class FirstImpact
    {
        /** The time of the earliest touch so far, or RelativeMotion.NEVER. Read only. */
        public var time:Number = RelativeMotion.NEVER;

        /** Touches up to this time count. Read only. */
        public var latest:Number = 0;

        // When the chosen one is touched, and how squarely it is met.
        private var _chosenTime:Number = RelativeMotion.NEVER;
        private var _squareness:Number = -Infinity;

        /** Begins. Touches up to a time count. */
        public function reset(latest:Number):void
        {
            time = _chosenTime = RelativeMotion.NEVER;
            _squareness = -Infinity;
            this.latest = latest;
        }

        /**
         * Takes a touch. Afterwards <code>time</code> and <code>latest</code> may be earlier, even if another touch stays the chosen one.
         *
         * @param motion of the shape, or of the other triangle, with the time of the touch
         * @param plane of the triangle
         * @param other of the other triangle; null if a shape touches the first one
         * @return whether it is the one that counts, of all so far
         */
        public function offer(motion:RelativeMotion, plane:TrianglePlane, other:TrianglePlane = null):Boolean
        {
            if (!(motion.time <= latest))
            {
                return false;
            }
            // Triangles of one plane are met equally squarely, up to rounding. The earliest of them counts.
            var needed:Number = 1 + Tolerances.DIRECTION;
            if (motion.time < time)
            {
                needed = 1 - Tolerances.DIRECTION;
                if (motion.time < _chosenTime - Tolerances.SAME_TIME)
                {
                    // the chosen one is clearly later, and does not count any more
                    _squareness = -Infinity;
                }
                time = motion.time;
                latest = time > 0 ? Math.min(latest, time + Tolerances.SAME_TIME) : 0;
            }
            var squareness:Number = squarenessOf(plane.normal, motion, -1);
            if (other != null)
            {
                squareness += squarenessOf(other.normal, motion, 1);
            }
            if (!(squareness > needed * _squareness))
            {
                return false;
            }
            _chosenTime = motion.time;
            _squareness = squareness;
            return true;
        }

        // The component of the motion against a plane, or along it if the side is 1. A plane that is met from behind counts only if none is met from
        // the front.
        private static function squarenessOf(normal:Vector3D, motion:RelativeMotion, side:int):Number
        {
            var speed:Number = side * (normal.x * motion.x + normal.y * motion.y + normal.z * motion.z);
            return speed > 0 ? speed : -Tolerances.DIRECTION * speed;
        }
    }
}
