package starlogo.queries
{
    /**
     * Answers all kinds of questions about the same agents. A filter's <code>accepts</code> may ask questions while a search waits for it. These
     * questions have a set of their own, so that search finds everything as it was.
     *
     * @private
     */
    public final class QuestionSet
    {
        /** Questions about places. */
        public var places:PlaceQuestions;

        /** Questions about touches. */
        public var touches:TouchQuestions;

        /** Questions about distances of surfaces. */
        public var distances:DistanceQuestions;

        /** Questions about rays. */
        public var rays:RayQuestions;

        /** Motions and casts. */
        public var moves:MoveQuestions;

        /** Walks. */
        public var walks:WalkQuestions;

        /** @param seen the agents that questions are about */
        public function QuestionSet(seen:SeenAgents)
        {
            places = new PlaceQuestions(seen);
            touches = new TouchQuestions(seen);
            distances = new DistanceQuestions(seen);
            rays = new RayQuestions(seen);
            moves = new MoveQuestions(seen);
            walks = new WalkQuestions(seen, moves);
        }
    }
}
