package starlogo.search
{
    import starlogo.engine;

    use namespace engine;

    /** What the pairs of a search depend on, besides the agents, the ground and the edges of the world. */
    internal final class SearchConditions
    {
        // In place of a depth: the triangles decide.
        private static const EXACT:int = 0;

        // The pairs of breeds that count, and their number. A game that calls findCollisionsAmong() may add some.
        private var _interests:BreedInterests = null;
        private var _interestCount:int = 0;

        // Whether an agent sweeps.
        private var _isSwept:Boolean = false;

        // Whether a filter decides which agents take part.
        private var _isFiltered:Boolean = false;

        // The depth to which trees are tested, or EXACT.
        private var _maxDepth:int = EXACT;

        /** Sets all. */
        public function setTo(input:SearchInput, isSwept:Boolean, limits:TreeLimits):void
        {
            _interests = input.interests;
            _interestCount = input.interests.pairCount;
            _isSwept = isSwept;
            _isFiltered = input.admitted != null;
            _maxDepth = depthIn(limits);
        }

        /** Whether the pairs of another search depend on the same. */
        public function areThoseOf(input:SearchInput, isSwept:Boolean, limits:TreeLimits):Boolean
        {
            return _interests === input.interests && _interestCount == input.interests.pairCount && _isSwept == isSwept
                && _isFiltered == (input.admitted != null) && _maxDepth == depthIn(limits);
        }

        private static function depthIn(limits:TreeLimits):int
        {
            return limits.exact ? EXACT : limits.maxDepth;
        }
    }
}
