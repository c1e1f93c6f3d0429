package starlogo.queries
{
    import starlogo.engine;

    use namespace engine;

    /**
     * Answers every kind of question, one at a time.
     *
     * @private
     */
    public final class AllQueries extends MotionQueries
    {
        /** What is near. */
        public var places:PlaceQueries;

        /** What touches. */
        public var touches:TouchQueries;

        /** How far apart. */
        public var distances:DistanceQueries;

        /** What a ray meets. */
        public var rays:RayQueries;

        /** @param seen the agents that questions are about */
        public function AllQueries(seen:QueryWorld)
        {
            super(seen);
            places = new PlaceQueries(room);
            touches = new TouchQueries(room);
            distances = new DistanceQueries(room);
            rays = new RayQueries(room);
        }
    }
}
