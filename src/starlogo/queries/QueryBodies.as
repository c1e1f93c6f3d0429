package starlogo.queries
{
    import flash.geom.Vector3D;
    import starlogo.agents.Agent;
    import starlogo.bounding.BoundingStructure;
    import starlogo.engine;
    import starlogo.search.Body;
    import starlogo.search.ModelShape;

    use namespace engine;

    /**
     * The bodies of the agents and structures that a question is about. A question that a filter's <code>accepts</code> asks has bodies of its own
     * (QuerySet), so the question that waits finds its own unchanged.
     *
     * @private
     */
    public final class QueryBodies
    {
        /** The body of a second agent or structure. */
        public var second:Body = new Body();

        private var _seen:QueryWorld;
        private var _first:Body = new Body();
        private var _place:Vector3D = new Vector3D();

        /** @param seen the agents that questions are about */
        public function QueryBodies(seen:QueryWorld)
        {
            _seen = seen;
        }

        /**
         * The body of an agent as it is now. Its shape is null while the agent's model is loading. Do not change it.
         *
         * @param made becomes this body if the agent has changed since the last update; null for the first of this set
         * @throws ArgumentError if the agent is null, or its model is unknown or lacks data that is needed
         */
        public function ofAgent(agent:Agent, made:Body = null):Body
        {
            QueryWorld.requireAgent(agent);
            return _seen.table.bodyOfNow(agent, made || _first);
        }

        /** The body of an agent that can move, as it is now. Throws the errors of <code>QueryWorld.placeOf()</code> and <code>ofAgent()</code>. */
        public function ofMoving(agent:Agent):Body
        {
            _seen.placeOf(agent);
            return ofAgent(agent);
        }

        /**
         * The body of an agent that goes straight on. A sphere, box or capsule becomes the body of a structure, so that an agent and the same
         * structure meet the same, to the last bit.
         */
        public function ofGoing(agent:Agent):Body
        {
            var body:Body = ofMoving(agent);
            if (body.shape == null || body.form >= ModelShape.TREE)
            {
                return body;
            }
            second.readPlaced(body);
            return second;
        }

        /** The body that an agent would have at a place. */
        public function ofAgentAt(agent:Agent, x:Number, y:Number, z:Number):Body
        {
            var body:Body = ofMoving(agent);
            if (body.shape == null)
            {
                return body;
            }
            _place.setTo(x, y, z);
            second.readShrunk(body, _place, 0);
            return second;
        }

        /** The body of a structure. Throws the errors of <code>Body.readStructure()</code>. */
        public function ofStructure(structure:BoundingStructure):Body
        {
            _first.readStructure(structure);
            return _first;
        }
    }
}
