package starlogo.queries
{
    import starlogo.agents.Agent;
    import starlogo.bounding.BoundingStructure;
    import starlogo.engine;
    import starlogo.search.Body;
    import starlogo.search.ModelShape;

    use namespace engine;

    /**
     * What a question works with: the agents that it sees, the collector of its answer, and bodies to write to. A question searches the trees
     * of a QueryWorld (NearSearch, SweptBoxSearch), tests what it finds (RowFilter, RowRays, Mover), and gives it to the Collector. Each kind
     * of question is a class with such a set: PlaceQueries, TouchQueries, DistanceQueries, RayQueries, MoveQueries, WalkQueries. A public class
     * names only the kinds that it needs: AgentPlaces, AgentRays, AgentWalks, or AgentQueries for all. Read this file first, then RayQueries
     * for a ray, or Mover for a motion.
     *
     * <p>A filter's <code>accepts</code> may ask questions while a search waits for it. These questions have a set of their own, so that search
     * finds everything as it was.</p>
     *
     * @private
     */
    public final class QuerySet
    {
        /** The agents that questions are about. */
        public var seen:QueryWorld;

        /** Collects the rows of the answer. */
        public var found:Collector;

        /** Finds the rows near a body, a way or a ray. */
        public var boxSearch:SweptBoxSearch = new SweptBoxSearch();

        /** The body of a second agent or structure, and the body that moves. */
        public var second:Body = new Body();

        private var _first:Body = new Body();

        /** @param seen the agents that questions are about */
        public function QuerySet(seen:QueryWorld)
        {
            this.seen = seen;
            found = new Collector(seen);
        }

        /**
         * The body of an agent as it is now. Its shape is null while the agent's model is loading. Do not change it.
         *
         * @param made becomes this body if the agent has changed since the last update; null for the first of this set
         * @throws ArgumentError if the agent is null, or its model is unknown or lacks data that is needed
         */
        public function bodyOf(agent:Agent, made:Body = null):Body
        {
            QueryWorld.requireAgent(agent);
            return seen.table.bodyOfNow(agent, made || _first);
        }

        /** The body of an agent that can move, as it is now. Throws the errors of <code>QueryWorld.placeOf()</code> and <code>bodyOf()</code>. */
        public function bodyOfMover(agent:Agent):Body
        {
            seen.placeOf(agent);
            return bodyOf(agent);
        }

        /**
         * The body of an agent that goes straight on. A sphere, box or capsule becomes the body of a structure, so that an agent and the same
         * structure meet the same, to the last bit.
         */
        public function bodyOfCast(agent:Agent):Body
        {
            var body:Body = bodyOfMover(agent);
            if (body.shape == null || body.form >= ModelShape.TREE)
            {
                return body;
            }
            second.readPlaced(body);
            return second;
        }

        /** The body that an agent would have at a place. */
        public function bodyAt(agent:Agent, x:Number, y:Number, z:Number):Body
        {
            var body:Body = bodyOfMover(agent);
            if (body.shape == null)
            {
                return body;
            }
            second.readShrunk(body, null, 0);
            second.placement.x = x;
            second.placement.y = y;
            second.placement.z = z;
            return second;
        }

        /** The body of a structure. Throws the errors of <code>Body.readStructure()</code>. */
        public function bodyOfStructure(structure:BoundingStructure):Body
        {
            _first.readStructure(structure);
            return _first;
        }

        /** Throws a RangeError if a number is negative or not a number. */
        public static function requireNotNegative(name:String, value:Number):void
        {
            if (!(value >= 0))
            {
                throw new RangeError(name + " must not be negative: " + value);
            }
        }
    }
}
