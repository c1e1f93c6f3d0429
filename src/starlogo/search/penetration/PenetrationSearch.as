package starlogo.search.penetration
{
    import starlogo.convex.ContactPoint;
    import starlogo.convex.RelativeMotion;
    import starlogo.search.Body;

    /**
     * Finds a normal and a depth for a contact that separate its two bodies. If the first one moves along the normal by the depth, the two
     * just touch, and a little farther they do not.
     *
     * <p>It begins with a push along the given normal (PushOut). The shortest way out of the structures around both bodies is tried too; if no
     * push is found, it gives the direction (DirectionSearch). The ground has many sides, and a search of its own (GroundExitSearch).</p>
     *
     * @private
     */
    public final class PenetrationSearch
    {
        private var _pair:DisplacedPair;
        private var _directions:DirectionSearch;
        private var _pushOut:PushOut;
        private var _groundExits:GroundExitSearch;

        // The same pair if the leaves of trees decide, or null. They find every touch that triangles find, in a tenth of the time.
        private var _leaves:DisplacedPair;
        private var _directionsOfLeaves:DirectionSearch;

        // The first contact; the contact of the structures around both; and the displacement that is tried.
        private var _first:ContactPoint = new ContactPoint();
        private var _outer:ContactPoint = new ContactPoint();
        private var _tried:Displacement = new Displacement();

        /**
         * @param pair knows whether its bodies touch, and when: a pair with a tree, or with the ground
         * @param leaves knows it by the leaves of trees; null for the ground
         */
        public function PenetrationSearch(pair:DisplacedPair, leaves:DisplacedPair = null)
        {
            _pair = pair;
            _leaves = leaves;
            _directionsOfLeaves = new DirectionSearch(leaves);
            _directions = new DirectionSearch(_pair);
            _pushOut = new PushOut(_pair, _directions);
            _groundExits = new GroundExitSearch(_pair, _directions, _pushOut);
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
            if (!isComing(motion) || _pair.areTouching())
            {
                findLeast(a, b, motion, out);
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
            _tried.distance = -Math.max(_pair.probeDistance, _pair.rounding);
            if (!_pair.testAt(_tried))
            {
                out.pointAgainst(motion);
            }
        }

        // Whether the first body moves, and touches the second only after the motion's beginning.
        private static function isComing(motion:RelativeMotion):Boolean
        {
            return motion.time > 0 && !motion.isStill;
        }

        // Finds the shortest way out that it can. If triangles decide and the depth is more than IMPROVED_DEPTH, the leaves find a direction
        // first, because their tests are fast.
        private function findLeast(a:Body, b:Body, motion:RelativeMotion, out:ContactPoint):void
        {
            _first.copyFrom(out);
            if (_pair.isSecondGround)
            {
                _groundExits.find(_first, out);
                return;
            }
            out.depth = Infinity;
            _pushOut.find(_first, Infinity, out);
            if (isComing(motion) && out.depth > DirectionSearch.IMPROVED_DEPTH * _pair.extent)
            {
                _first.pointAgainst(motion);
                _first.depth = 0;
                _pushOut.find(_first, DirectionSearch.GAIN * out.depth, out);
            }
            if (out.depth == 0)
            {
                return;
            }
            if (_pair.haveTriangles && out.depth > DirectionSearch.IMPROVED_DEPTH * _pair.extent)
            {
                _leaves.begin(a, b, motion);
                tryOuter(_leaves, _directionsOfLeaves, out);
                _directions.findAlong(out, out);
                return;
            }
            tryOuter(_pair, _directions, out);
        }

        // Tries to go straight along the shortest way out of the structures around both bodies of a pair.
        private function tryOuter(pair:DisplacedPair, directions:DirectionSearch, out:ContactPoint):void
        {
            pair.putBack();
            pair.findOuterContact(_outer);
            if (out.depth == Infinity)
            {
                directions.findAlong(_outer, out);
                return;
            }
            _tried.setDirection(_outer.normalX, _outer.normalY, _outer.normalZ);
            _tried.distance = out.depth - pair.tolerance;
            if (_tried.distance > 0 && !pair.testAt(_tried))
            {
                directions.shorten(_tried, out);
            }
        }
    }
}
