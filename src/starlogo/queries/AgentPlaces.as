package starlogo.queries
{
    import flash.geom.Vector3D;
    import starlogo.agents.Agent;
    import starlogo.geometry.requireGiven;

    /**
     * Answers which agents are near: the questions of AgentQueries about places, for games that load no others. Their rules stand there.
     */
    public final class AgentPlaces
    {
        private var _questions:PlaceQueries;

        /**
         * Asks about the agents of a SeenAgents. Others may ask about the same.
         *
         * @param seen the agents that the questions see
         * @throws ArgumentError if it is null
         */
        public function AgentPlaces(seen:SeenAgents)
        {
            requireGiven("seen", seen);
            _questions = new PlaceQueries(seen);
        }

        /** See AgentQueries.near. It has the same arguments, answers and errors. */
        public function near(agent:Agent, radius:Number, filter:AgentFilter = null, out:Vector.<Agent> = null):Vector.<Agent>
        {
            return _questions.idle.near(agent, radius, filter, out);
        }

        /** See AgentQueries.countNear. It has the same arguments, answers and errors. */
        public function countNear(agent:Agent, radius:Number, filter:AgentFilter = null):int
        {
            return _questions.idle.countNear(agent, radius, filter);
        }

        /** See AgentQueries.nearest. It has the same arguments, answers and errors. */
        public function nearest(agent:Agent, radius:Number = Infinity, filter:AgentFilter = null):Agent
        {
            return _questions.idle.nearest(agent, radius, filter);
        }

        /** See AgentQueries.nearestFew. It has the same arguments, answers and errors. */
        public function nearestFew(agent:Agent, count:int, radius:Number = Infinity, filter:AgentFilter = null, out:Vector.<Agent> = null):Vector.<Agent>
        {
            return _questions.idle.nearestFew(agent, count, radius, filter, out);
        }

        /** See AgentQueries.nearPoint. It has the same arguments, answers and errors. */
        public function nearPoint(point:Vector3D, radius:Number, filter:AgentFilter = null, out:Vector.<Agent> = null):Vector.<Agent>
        {
            return _questions.idle.nearPoint(point, radius, filter, out);
        }

        /** See AgentQueries.countNearPoint. It has the same arguments, answers and errors. */
        public function countNearPoint(point:Vector3D, radius:Number, filter:AgentFilter = null):int
        {
            return _questions.idle.countNearPoint(point, radius, filter);
        }

        /** See AgentQueries.nearestToPoint. It has the same arguments, answers and errors. */
        public function nearestToPoint(point:Vector3D, radius:Number = Infinity, filter:AgentFilter = null):Agent
        {
            return _questions.idle.nearestToPoint(point, radius, filter);
        }

        /** See AgentQueries.inCone. It has the same arguments, answers and errors. */
        public function inCone(agent:Agent, radius:Number, degrees:Number, filter:AgentFilter = null, out:Vector.<Agent> = null):Vector.<Agent>
        {
            return _questions.idle.inCone(agent, radius, degrees, filter, out);
        }
    }
}
