package starlogo.collision
{
    import starlogo.engine;
    import starlogo.search.SearchCounts;

    use namespace engine;

    /**
     * Counts and times of one frame of collision detection. The next frame overwrites them; copy numbers that you want to keep.
     *
     * <p>Candidates and tests are counted as the frame has made them. If few agents have changed since the last frame, a frame tests only the
     * pairs of these agents. So these counts depend on the frames before, also on whether there was a frame before.</p>
     */
    public final class CollisionStatistics extends SearchCounts
    {
        private static const ZERO:CollisionStatistics = new CollisionStatistics();

        /** Calls of handlers. */
        public var handlerCalls:int;

        /**
         * Milliseconds to find the collisions. A Flash player's clock counts whole milliseconds only, so the time of one frame says little.
         * CollisionRecorder has the mean of many frames.
         */
        public var findMs:Number = 0;

        /** Milliseconds of the whole frame, handlers included. In a Flash player it is a whole number, as findMs is. */
        public var frameMs:Number = 0;

        /** The most important counts of the frame, in words. */
        public function toString():String
        {
            return agents + " agents, " + candidatePairs + " candidates, " + collisions + " collisions, " + handlerCalls + " calls of handlers, "
                + frameMs + " ms";
        }

        /** Sets every number to 0. */
        public function reset():void
        {
            copyFrom(ZERO);
        }

        /** Copies every number of another frame. */
        public function copyFrom(other:CollisionStatistics):void
        {
            copyCounts(other);
            handlerCalls = other.handlerCalls;
            findMs = other.findMs;
            frameMs = other.frameMs;
        }
    }
}
