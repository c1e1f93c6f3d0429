package starlogo.solid
{
    import flash.geom.Vector3D;
    import starlogo.convex.RelativeMotion;
    import starlogo.convex.TrianglePlane;
    import starlogo.geometry.Tolerances;

    /**
     * Chooses the triangle, or the pair of triangles, that makes the contact of an impact: the one that is touched first. The more squarely the motion
     * meets a plane, the earlier its touch counts, by up to Tolerances.SAME_TIME. So a shape that moves along a side, flush with it, and then meets
     * another side, touches the one that stops it. Of touches that count as equally early, the first one that is offered
     * makes the contact. So there the order of a model's triangles decides.
     *
     * <p>What touches at time 0 ends the search: the first one found makes the contact, because nothing is earlier. If the models overlap there, it
     * depends on the order of the triangles which one that is. The push out of an overlap is another search.</p>
     *
     * @private
     */
    public final class FirstImpact
    {
        /** The time of the earliest touch so far, or RelativeMotion.NEVER. */
        public var time:Number = RelativeMotion.NEVER;

        /** The chosen triangles, or nodes if boxes decide: that of tree a and that of tree b. -1 for none. The asker of <code>offer()</code> writes them. */
        public var a:int = -1;
        public var b:int = -1;

        // The chosen one's time, which counts as earlier the more squarely the motion meets the plane.
        private var _rank:Number = RelativeMotion.NEVER;

        /** Begins. */
        public function reset():void
        {
            time = _rank = RelativeMotion.NEVER;
            a = b = -1;
        }

        /**
         * Takes a touch, which counts if it is no later than the motion's latest time. Afterwards <code>time</code> and that latest time may be earlier, even
         * if another touch stays the chosen one.
         *
         * @param motion of the shape, or of the other triangle, with the time of the touch; receives its latest time
         * @param plane of the triangle
         * @param other of the other triangle; null if a shape touches the first one
         * @return whether it is the one that counts, of all so far
         */
        public function offer(motion:RelativeMotion, plane:TrianglePlane, other:TrianglePlane = null):Boolean
        {
            if (!(motion.time <= motion.latestTime))
            {
                return false;
            }
            if (motion.time < time)
            {
                time = motion.time;
                motion.latestTime = time > 0 ? Math.min(motion.latestTime, time + Tolerances.SAME_TIME) : 0;
            }
            var approach:Number = approachTo(plane.normal, motion, -1);
            if (other != null)
            {
                approach = (approach + approachTo(other.normal, motion, 1)) / 2;
            }
            var length:Number = Math.sqrt(motion.x * motion.x + motion.y * motion.y + motion.z * motion.z);
            var squareness:Number = length > 0 ? approach / length : 0;
            var rank:Number = motion.time - Tolerances.SAME_TIME * squareness;
            if (!(rank < _rank))
            {
                return false;
            }
            _rank = rank;
            return true;
        }

        // The component of the motion against a plane, or along it if the sign is 1. A plane that is met from behind counts only if none is met from
        // the front.
        private static function approachTo(normal:Vector3D, motion:RelativeMotion, sign:int):Number
        {
            var speed:Number = sign * (normal.x * motion.x + normal.y * motion.y + normal.z * motion.z);
            return speed > 0 ? speed : -Tolerances.DIRECTION * speed;
        }
    }
}
