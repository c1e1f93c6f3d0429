package starlogo.queries
{
    /**
     * Answers questions about motions, one at a time.
     *
     * @private
     */
    public class MotionQueries
    {
        /** What the questions work with. */
        public var room:QuerySet;

        /** What a motion meets. */
        public var moves:MoveQueries;

        /** How a character walks. */
        public var walks:WalkQueries;

        /** @param seen the agents that questions are about */
        public function MotionQueries(seen:QueryWorld)
        {
            room = new QuerySet(seen);
            moves = new MoveQueries(room);
            walks = new WalkQueries(room, moves);
        }
    }
}
