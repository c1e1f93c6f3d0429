package starlogo.queries
{
    import starlogo.engine;

    use namespace engine;

    /**
     * Answers every kind of question, one at a time.
     *
     * @private
     */
    public final class AllQueries
    {
        /** What the questions work with. */
        public var room:QuerySet;

        /** What is near. */
        public var places:PlaceQueries;

        /** What touches. */
        public var touches:TouchQueries;

        /** How far apart. */
        public var distances:DistanceQueries;

        /** What a ray meets. */
        public var rays:RayQueries;

        /** What a motion meets. */
        public var moves:MoveQueries;

        /** How a character walks. */
        public var walks:WalkQueries;

        /** @param seen the agents that questions are about */
        public function AllQueries(seen:QueryWorld)
        {
            room = new QuerySet(seen);
            places = new PlaceQueries(room);
            touches = new TouchQueries(room);
            distances = new DistanceQueries(room);
            rays = new RayQueries(room);
            moves = new MoveQueries(room);
            walks = new WalkQueries(room, moves);
        }
    }
}
