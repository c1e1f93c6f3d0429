package starlogo.search
{
    import starlogo.engine;

    use namespace engine;

    /** What the pairs of a search depend on, besides the agents, the ground and the edges of the world. A record. */
    internal final class SearchConditions
    {
        // In place of a depth: the triangles decide.
        private static const EXACT:int = 0;

        /** The pairs of breeds that count. A Collision adds no pairs to these later. */
        public var interests:BreedInterests = null;

        /** Whether an agent sweeps. */
        public var isSwept:Boolean = false;

        /** Whether a filter decides which agents take part. */
        public var isFiltered:Boolean = false;

        /** The depth to which trees are tested, or EXACT. */
        public var maxDepth:int = EXACT;

        /** Sets all. */
        public function setTo(input:FrameInput, isSwept:Boolean, limits:TreeLimits):void
        {
            interests = input.interests;
            this.isSwept = isSwept;
            isFiltered = input.admitted != null;
            maxDepth = depthIn(limits);
        }

        /** Whether the pairs of another search depend on the same. */
        public function areThoseOf(input:FrameInput, isSwept:Boolean, limits:TreeLimits):Boolean
        {
            return interests === input.interests && this.isSwept == isSwept && isFiltered == (input.admitted != null) && maxDepth == depthIn(limits);
        }

        private static function depthIn(limits:TreeLimits):int
        {
            return limits.exact ? EXACT : limits.maxDepth;
        }
    }
}
