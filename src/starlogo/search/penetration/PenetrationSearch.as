// This folder finds short ways out of overlaps, for contacts that separate two bodies. A DisplacedPair puts the first body to places that are tried.
// TreeExitSearch and GroundExitSearch try pushes out of all contacts so far (PushOut, with PushQueue and HalfSpaceSolver), and look for the end of
// a way along one direction (DirectionSearch). Read this file first, then PushOut, then TreeExitSearch.
package starlogo.search.penetration
{
    import flash.errors.IllegalOperationError;
    import starlogo.convex.ContactPoint;
    import starlogo.convex.RelativeMotion;
    import starlogo.search.Body;

    /**
     * Finds a normal and a depth for a contact that separate its two bodies. If the first one moves along the normal by the depth, the two
     * just touch, and a little farther they do not. A subclass finds the way out: TreeExitSearch or GroundExitSearch.
     *
     * @private
     */
    public class PenetrationSearch
    {
        private var _pair:DisplacedPair;

        // The displacement that is tried.
        private var _tried:Displacement = new Displacement();

        /** @param pair knows whether its bodies touch, and when */
        public function PenetrationSearch(pair:DisplacedPair)
        {
            _pair = pair;
        }

        /**
         * Changes a contact's normal and depth so that they separate the two bodies.
         *
         * @param motion the motion of the first body relative to the second, with the time at which they touch. It ends where the first body is
         * @param out the contact of two parts that touch at that time
         */
        public final function find(a:Body, b:Body, motion:RelativeMotion, out:ContactPoint):void
        {
            _pair.begin(a, b, motion);
            // only a body that moves may have been stopped just before the touch
            if (!isComing(motion) || _pair.areTouching())
            {
                findExit(a, b, motion, out);
            }
            else
            {
                findGrazing(motion, out);
            }
            _pair.putBack();
            OverlapMiddle.movePoint(_pair.first, b, out);
            OverlapMiddle.keepWithin(_pair.first, out);
            OverlapMiddle.keepWithin(b, out);
        }

        /**
         * Finds a short way out of the second body for the first, which touches it. The pair has begun with the same bodies and the same motion.
         *
         * @param motion as in find
         * @param out the contact of two parts that touch; receives the normal and the depth of the way
         */
        protected function findExit(a:Body, b:Body, motion:RelativeMotion, out:ContactPoint):void
        {
            throw new IllegalOperationError(this + " does not implement findExit");
        }

        /** Whether the first body moves, and touches the second only after the motion's beginning. */
        internal static function isComing(motion:RelativeMotion):Boolean
        {
            return motion.time > 0 && !motion.isStill;
        }

        // Handles two bodies that do not touch at the time, because of rounding. The depth is 0. The normal points against the motion, unless the
        // two touch if the first one moves a little against the given normal.
        private function findGrazing(motion:RelativeMotion, out:ContactPoint):void
        {
            out.depth = 0;
            _tried.setDirection(out.normalX, out.normalY, out.normalZ);
            _tried.distance = -_pair.probeDistance;
            if (!_pair.testAt(_tried))
            {
                out.pointAgainst(motion);
            }
        }
    }
}
