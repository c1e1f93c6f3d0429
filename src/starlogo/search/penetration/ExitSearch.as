package starlogo.search.penetration
{
    import flash.errors.IllegalOperationError;
    import starlogo.convex.ContactPoint;
    import starlogo.convex.RelativeMotion;
    import starlogo.search.Body;

    /**
     * Finds a short way out of the second of two bodies for the first, which touches it. There is one for trees, and one for the ground.
     *
     * @private
     */
    public class ExitSearch
    {
        /**
         * Finds a way out. The pair of the search has begun with the same bodies and the same motion.
         *
         * @param motion the motion of the first body relative to the second, with the time at which they touch
         * @param out the contact of two parts that touch then; receives the normal and the depth of the way
         */
        public function find(a:Body, b:Body, motion:RelativeMotion, out:ContactPoint):void
        {
            throw new IllegalOperationError(this + " does not implement find");
        }

        /** Whether the first body moves, and touches the second only after the motion's beginning. */
        internal static function isComing(motion:RelativeMotion):Boolean
        {
            return motion.time > 0 && !motion.isStill;
        }
    }
}
