package starlogo.search.penetration
{
    import starlogo.convex.ContactPoint;
    import starlogo.convex.RelativeMotion;
    import starlogo.search.Body;

    /**
     * Finds a normal and a depth for a contact that separate its two bodies. If the first one moves along the normal by the depth, the two
     * just touch, and a little farther they do not. An ExitSearch finds the way out: TreeExitSearch or GroundExitSearch.
     *
     * @private
     */
    public final class PenetrationSearch
    {
        private var _pair:DisplacedPair;
        private var _exits:ExitSearch;

        // The displacement that is tried.
        private var _tried:Displacement = new Displacement();

        /**
         * @param pair knows whether its bodies touch, and when
         * @param exits finds the ways out of this pair
         */
        public function PenetrationSearch(pair:DisplacedPair, exits:ExitSearch)
        {
            _pair = pair;
            _exits = exits;
        }

        /**
         * Changes a contact's normal and depth so that they separate the two bodies.
         *
         * @param motion the motion of the first body relative to the second, with the time at which they touch. It ends where the first body is
         * @param out the contact of two parts that touch at that time
         */
        public function find(a:Body, b:Body, motion:RelativeMotion, out:ContactPoint):void
        {
            _pair.begin(a, b, motion);
            // only a body that moves may have been stopped just before the touch
            if (!ExitSearch.isComing(motion) || _pair.areTouching())
            {
                _exits.find(a, b, motion, out);
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
