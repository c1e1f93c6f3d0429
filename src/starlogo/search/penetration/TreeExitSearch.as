package starlogo.search.penetration
{
    import starlogo.convex.ContactPoint;
    import starlogo.convex.RelativeMotion;
    import starlogo.search.Body;
    import starlogo.search.TreeLimits;
    import starlogo.search.pairs.PairTests;
    import starlogo.search.pairs.TreePairTests;

    /**
     * Finds a short way out for a pair with a tree. It pushes the first body along the given normal (PushOut). The shortest way out of the structures
     * around both bodies is tried too; if no push is found, it gives the direction (DirectionSearch).
     *
     * @private
     */
    public final class TreeExitSearch
    {
        private var _tests:TreePairTests;
        private var _pair:DisplacedPair;
        private var _directions:DirectionSearch;
        private var _pushOut:PushOut;
        private var _limits:TreeLimits;

        // The same pair if the leaves of trees decide. They find every touch that triangles find, in a tenth of the time.
        private var _leaves:DisplacedPair;
        private var _directionsOfLeaves:DirectionSearch;

        // The first contact; the contact of the structures around both; and the displacement that is tried.
        private var _first:ContactPoint = new ContactPoint();
        private var _ofStructures:ContactPoint = new ContactPoint();
        private var _tried:Displacement = new Displacement();

        /**
         * @param tests the tests of a pair with a tree
         * @param leafTests the same tests by the leaves of trees
         * @param limits say whether triangles decide
         */
        public function TreeExitSearch(tests:TreePairTests, leafTests:PairTests, limits:TreeLimits)
        {
            _tests = tests;
            _limits = limits;
            _pair = new DisplacedPair(tests);
            _directions = new DirectionSearch(_pair);
            _pushOut = new PushOut(_pair, _directions);
            _leaves = new DisplacedPair(leafTests);
            _directionsOfLeaves = new DirectionSearch(_leaves);
        }

        /**
         * Changes a contact's normal and depth so that they separate two bodies: if the first one moves along the normal by the depth, the two just
         * touch, and a little farther they do not.
         *
         * @param motion the motion of the first body relative to the second, with the time at which they touch. It ends where the first body is
         * @param out the contact of two parts that touch at that time
         */
        public function find(a:Body, b:Body, motion:RelativeMotion, out:ContactPoint):void
        {
            _pair.begin(a, b, motion);
            if (!_pair.findGrazing(motion, out))
            {
                findExit(a, b, motion, out);
            }
            _pair.finish(out);
        }

        // Finds a way out for two bodies that touch. If triangles decide and the depth is more than IMPROVED_DEPTH, the leaves find a direction first,
        // because their tests are fast.
        private function findExit(a:Body, b:Body, motion:RelativeMotion, out:ContactPoint):void
        {
            _first.copyFrom(out);
            out.depth = Infinity;
            _pushOut.find(_first, Infinity, out);
            if (DisplacedPair.isComing(motion) && out.depth > DirectionSearch.IMPROVED_DEPTH * _pair.extent)
            {
                _first.pointAgainst(motion);
                _first.depth = 0;
                _pushOut.find(_first, DirectionSearch.GAIN * out.depth, out);
            }
            if (out.depth == 0)
            {
                return;
            }
            if (_limits.exact && out.depth > DirectionSearch.IMPROVED_DEPTH * _pair.extent)
            {
                _leaves.begin(a, b, motion);
                tryOutOfStructures(_leaves, _directionsOfLeaves, out);
                _directions.findAlong(out, out);
                return;
            }
            tryOutOfStructures(_pair, _directions, out);
        }

        // Tries to go straight along the shortest way out of the structures around both bodies of a pair.
        private function tryOutOfStructures(pair:DisplacedPair, directions:DirectionSearch, out:ContactPoint):void
        {
            pair.putBack();
            _tests.findContactOfStructures(pair.first, pair.second, _ofStructures);
            if (out.depth == Infinity)
            {
                directions.findAlong(_ofStructures, out);
                return;
            }
            _tried.setDirection(_ofStructures.normalX, _ofStructures.normalY, _ofStructures.normalZ);
            _tried.distance = out.depth - pair.tolerance;
            if (_tried.distance > 0 && !pair.testAt(_tried))
            {
                directions.shorten(_tried, out);
            }
        }
    }
}
