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

        // Answers what an accepts asks while these questions call it.
        private var _nested:MotionQueries = null;

        /** @param seen the agents that the questions are about */
        public function MotionQueries(seen:SeenAgents)
        {
            var mover:Mover = new Mover(seen);
            _seen = seen;
            moves = new MoveQueries(seen, mover);
            walks = new WalkQueries(seen, moves, mover);
        }

        /** These questions, or the nested ones while a filter's <code>accepts</code> is being called. */
        public function get idle():MotionQueries
        {
            return moves.isAsking ? (_nested ||= new MotionQueries(_seen)).idle : this;
        }
    }
}
