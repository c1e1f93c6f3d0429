package starlogo.queries
{
    import flash.geom.Vector3D;
    import starlogo.agents.Agent;
    import starlogo.geometry.requireGiven;

    /**
     * Answers what a ray meets: the questions of AgentQueries about rays, for games that load no others. Their rules stand there.
     */
    public final class AgentRays
    {
        private var _questions:RayQueries;

        /**
         * Asks about the agents of a SeenAgents. Others may ask about the same.
         *
         * @param seen the agents that the questions see
         * @throws ArgumentError if it is null
         */
        public function AgentRays(seen:SeenAgents)
        {
            requireGiven("seen", seen);
            _questions = new RayQueries(seen);
        }

        /** See AgentQueries.cast. It has the same arguments, answers and errors. */
        public function cast(origin:Vector3D, direction:Vector3D, maxDistance:Number = Infinity, filter:AgentFilter = null, hit:RayHit = null):RayHit
        {
            return _questions.idle.cast(origin, direction, maxDistance, filter, hit);
        }

        /** See AgentQueries.castAll. It has the same arguments, answers and errors. */
        public function castAll(origin:Vector3D, direction:Vector3D, maxDistance:Number = Infinity, filter:AgentFilter = null,
                out:Vector.<RayHit> = null, allSurfaces:Boolean = false):Vector.<RayHit>
        {
            return _questions.idle.castAll(origin, direction, maxDistance, filter, out, allSurfaces);
        }

        /** See AgentQueries.canSee. It has the same arguments, answers and errors. */
        public function canSee(a:Agent, b:Agent, filter:AgentFilter = null):Boolean
        {
            return _questions.idle.canSee(a, b, filter);
        }
    }
}
