package starlogo.queries
{
    import starlogo.agents.Agent;
    import starlogo.engine;
    import starlogo.terrain.Terrain;

    use namespace engine;

    /**
     * The agents that questions see, for games that load only some kinds of questions: AgentPlaces (what is near), AgentRays (what a ray
     * meets), AgentWalks (how far something can go). All of them may share one SeenAgents. An AgentQueries has all questions, and agents of
     * its own.
     *
     * <listing version="3.0">
     * var seen:SeenAgents = new SeenAgents(collision);
     * var places:AgentPlaces = new AgentPlaces(seen);
     * // every frame
     * seen.update(agents);
     * var prey:Agent = places.nearest(agents[0], 20);
     * </listing>
     */
    public final class SeenAgents
    {
        private var _world:QueryWorld;

        /**
         * Begins without agents, as an AgentQueries does.
         *
         * @param collisionOrShapes a Collision, one of the engine's collision systems, or a LevelShapes. It decides how agents are seen
         * @throws ArgumentError if it is none of these, or if the Collision's system is not one of the engine's
         */
        public function SeenAgents(collisionOrShapes:Object)
        {
            _world = new QueryWorld(collisionOrShapes);
        }

        /** The ground that rays, walks and the like meet. See AgentQueries. It may be null. */
        public function get terrain():Terrain
        {
            return _world.terrain;
        }

        public function set terrain(value:Terrain):void
        {
            _world.terrain = value;
        }

        /**
         * Reads the agents, once a frame. Questions see them as they are now, until the next update. See AgentQueries.
         *
         * @param agents the agents. The list is copied
         * @throws ArgumentError if the list or an agent in it is null, an agent is listed twice, or its model is unknown
         * @throws flash.errors.IllegalOperationError if called from a filter's <code>accepts</code>
         */
        public function update(agents:Vector.<Agent>):void
        {
            _world.update(agents);
        }

        /**
         * Reads one agent again, which has changed since the last update.
         *
         * @param agent an agent of the last update
         * @throws ArgumentError if the agent is not in the list
         * @throws flash.errors.IllegalOperationError if called from a filter's <code>accepts</code>
         */
        public function refresh(agent:Agent):void
        {
            _world.moved(agent);
        }

        /** @private */
        engine function get world():QueryWorld
        {
            return _world;
        }
    }
}
