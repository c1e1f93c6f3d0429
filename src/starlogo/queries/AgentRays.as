package starlogo.queries
{
    import flash.geom.Vector3D;
    import starlogo.agents.Agent;
    import starlogo.engine;
    import starlogo.geometry.requireGiven;

    use namespace engine;

    /**
     * Answers what a ray meets: the questions of AgentQueries about rays, for games that load no others. Their rules stand there.
     */
    public final class AgentRays
    {
        private var _world:QueryWorld;

        // By the number of questions under way that call accepts.
        private var _sets:Vector.<RayQueries> = new Vector.<RayQueries>();

        /**
         * Asks about the agents of a SeenAgents. Others may ask about the same.
         *
         * @param seen the agents that the questions see
         * @throws ArgumentError if it is null
         */
        public function AgentRays(seen:SeenAgents)
        {
            requireGiven("seen", seen);
            _world = seen.world;
        }

        /** See AgentQueries.cast. It has the same arguments and the same answer. */
        public function cast(origin:Vector3D, direction:Vector3D, maxDistance:Number = Infinity, filter:AgentFilter = null, hit:RayHit = null):RayHit
        {
            return ask.cast(origin, direction, maxDistance, filter, hit);
        }

        /** See AgentQueries.castAll. It has the same arguments and the same answer. */
        public function castAll(origin:Vector3D, direction:Vector3D, maxDistance:Number = Infinity, filter:AgentFilter = null,
                out:Vector.<RayHit> = null, allSurfaces:Boolean = false):Vector.<RayHit>
        {
            return ask.castAll(origin, direction, maxDistance, filter, out, allSurfaces);
        }

        /** See AgentQueries.canSee. It has the same arguments and the same answer. */
        public function canSee(a:Agent, b:Agent, filter:AgentFilter = null):Boolean
        {
            return ask.canSee(a, b, filter);
        }

        private function get ask():RayQueries
        {
            // other questions may be under way
            while (_world.asking >= _sets.length)
            {
                _sets.push(new RayQueries(new QuerySet(_world)));
            }
            return _sets[_world.asking];
        }
    }
}
