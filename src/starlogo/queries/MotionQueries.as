package starlogo.queries
{
    /**
     * Answers questions about motions, one at a time.
     *
     * @private
     */
    public final class MotionQueries
    {
        /** What a motion meets. */
        public var moves:MoveQueries;

        /** How a character walks. */
        public var walks:WalkQueries;

        private var _seen:SeenAgents;

        // For the questions of an accepts that these call.
        private var _nested:MotionQueries = null;

        /** @param seen the agents that the questions are about */
        public function MotionQueries(seen:SeenAgents)
        {
            var mover:Mover = new Mover(seen);
            _seen = seen;
            moves = new MoveQueries(seen, mover);
            walks = new WalkQueries(seen, moves, mover);
        }

        /** These questions; others while these call a filter's <code>accepts</code>, which may ask questions itself. */
        public function get idle():MotionQueries
        {
            if (!moves.isAsking)
            {
                return this;
            }
            _nested ||= new MotionQueries(_seen);
            return _nested.idle;
        }
    }
}
