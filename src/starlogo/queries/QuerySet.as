package starlogo.queries
{
    import starlogo.agents.Agent;
    import starlogo.bounding.BoundingStructure;
    import starlogo.engine;
    import starlogo.search.AgentTable;
    import starlogo.search.Body;
    import starlogo.search.ModelShape;
    import starlogo.search.ListedAgents;

    use namespace engine;

    /**
     * Answers all kinds of questions about the same agents: what is near, what is met or touched, how far apart, how far a body can go. A question
     * searches the trees of a QueryWorld (NearSearch, SweptBoxSearch), tests what it finds (RowFilter, RowRays, Mover), and gives it to the
     * Collector. Read this file first, then RayQueries for a ray, or Mover for a motion.
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

        /** Tests where a ray meets a row. */
        public var rowRays:RowRays;

        /** The body of a second agent or structure, and the body that moves. */
        public var second:Body = new Body();

        /** Questions about distances of surfaces. */
        public var distances:DistanceQueries;

        /** Questions about rays. */
        public var rays:RayQueries;

        /** Motions and casts. */
        public var moves:MoveQueries;

        /** Walks. */
        public var walks:WalkQueries;

        private var _first:Body = new Body();
        private var _near:NearSearch = new NearSearch();
        private var _count:CountSearch = new CountSearch();
        private var _cone:Cone = new Cone();

        /** @param seen the agents that questions are about */
        public function QuerySet(seen:QueryWorld)
        {
            this.seen = seen;
            found = new Collector(seen);
            rowRays = new RowRays(seen);
            distances = new DistanceQueries(this);
            rays = new RayQueries(this);
            moves = new MoveQueries(this);
            walks = new WalkQueries(this);
        }

        /**
         * Finds the agents near a place.
         *
         * @param asker the agent that asks, which is left out; or null
         * @param x the place
         * @param y the place
         * @param z the place
         * @param radius the largest distance
         * @param wanted how many of the nearest agents are wanted, or Collector.ALL
         * @param filter the agents that count; null for all
         * @param degrees the angle of a cone in front of the asker; from 360 on there is no cone
         * @return has the answer
         */
        public function near(asker:Agent, x:Number, y:Number, z:Number, radius:Number, wanted:int, filter:AgentFilter, degrees:Number = 360):Collector
        {
            requireNotNegative("radius", radius);
            found.begin(wanted, radius * radius, asker, filter);
            var cone:Cone = degrees < 360 ? _cone.setTo(asker.worldPlacement(), degrees / 2) : null;
            _near.find(seen.findPlaces(), x, y, z, found, cone);
            return found;
        }

        /** Counts the agents near a place. The parameters are those of <code>near()</code>. */
        public function countNear(asker:Agent, x:Number, y:Number, z:Number, radius:Number, filter:AgentFilter):int
        {
            if (filter != null && filter.accepts != null)
            {
                return near(asker, x, y, z, radius, Collector.ALL, filter).end();
            }
            requireNotNegative("radius", radius);
            found.filter.begin(asker, filter);
            return _count.count(seen.findPlaces(), x, y, z, radius * radius, found.filter);
        }

        /**
         * Finds the agents that touch a body. They are sorted by the distances of their places from the body's place.
         *
         * @param asker the agent that asks, which is left out; or null
         * @param body the body that asks. While its model is loading it touches nothing
         * @param wanted Collector.ALL; or 1 for any agent that touches
         * @param filter the agents that count; null for all
         * @return has the answer
         */
        public function touching(asker:Agent, body:Body, wanted:int, filter:AgentFilter):Collector
        {
            var table:AgentTable = seen.table;
            var answer:Collector = found;
            var search:SweptBoxSearch = boxSearch;
            answer.begin(wanted, Infinity, asker, filter);
            if (body.shape == null)
            {
                return answer;
            }
            seen.beginWay(search, body);
            // if one row is wanted, it may be any that touches
            for (var other:int = answer.nextOf(search); other >= 0 && !answer.hasAny; other = answer.nextOf(search))
            {
                if (seen.narrowPhase.areTouching(body, table.bodyOf(other)))
                {
                    var toX:Number = table.places.now.x[other] - body.placement.x;
                    var toY:Number = table.places.now.y[other] - body.placement.y;
                    var toZ:Number = table.places.now.z[other] - body.placement.z;
                    // the ground has no place, so it comes last
                    answer.add(other, other == ListedAgents.GROUND ? Infinity : toX * toX + toY * toY + toZ * toZ);
                }
            }
            return answer;
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
