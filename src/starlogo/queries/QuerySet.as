package starlogo.queries
{
    import starlogo.agents.Agent;
    import starlogo.engine;
    import starlogo.search.AgentTable;
    import starlogo.search.Body;
    import starlogo.search.RowList;

    use namespace engine;

    /**
     * Answers all kinds of questions about the same agents. A filter's <code>accepts</code> may ask questions while a search waits for it. These
     * questions have a set of their own, so that search finds everything as it was.
     *
     * @private
     */
    public final class QuerySet
    {
        /** Questions about distances of surfaces. */
        public var distances:DistanceQueries;

        /** Questions about rays. */
        public var rays:RayQueries;

        /** Motions and casts. */
        public var moves:MoveQueries;

        /** Walks. */
        public var walks:WalkQueries;

        /** The bodies of the agents and structures that questions are about. */
        public var bodies:QueryBodies;

        private var _seen:QueryWorld;
        private var _found:Collector;
        private var _near:NearSearch = new NearSearch();
        private var _way:SweptBoxSearch = new SweptBoxSearch();
        private var _cone:Cone = new Cone();

        /** @param seen the agents that questions are about */
        public function QuerySet(seen:QueryWorld)
        {
            _seen = seen;
            _found = new Collector(seen);
            bodies = new QueryBodies(seen);
            distances = new DistanceQueries(seen, bodies);
            rays = new RayQueries(seen, bodies, _found, _way);
            moves = new MoveQueries(seen, bodies, _found, _way);
            walks = new WalkQueries(seen, bodies, moves);
        }

        /**
         * Finds the agents near a place.
         *
         * @param asker the agent that asks, which is left out; or null
         * @param x the place
         * @param y the place
         * @param z the place
         * @param radius the largest distance
         * @param wanted how many of the nearest agents are wanted; or Collector.ALL or Collector.NUMBER
         * @param filter the agents that count; null for all
         * @param degrees the angle of a cone in front of the asker; from 360 on there is no cone
         * @return has the answer
         */
        public function near(asker:Agent, x:Number, y:Number, z:Number, radius:Number, wanted:int, filter:AgentFilter, degrees:Number = 360):Collector
        {
            requirePositive("radius", radius);
            _found.begin(wanted, radius * radius, asker, filter);
            if (degrees < 360)
            {
                _found.cone = _cone.setTo(asker.worldPlacement(), degrees / 2, _seen.table);
            }
            _near.find(_seen.findPlaces(), x, y, z, _found);
            return _found;
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
            var table:AgentTable = _seen.table;
            var found:Collector = _found;
            found.begin(wanted, Infinity, asker, filter);
            if (body.shape == null)
            {
                return found;
            }
            _seen.beginWay(_way, body);
            // if one row is wanted, it may be any that touches
            for (var other:int = found.nextOf(_way); other >= 0 && !(found.keepsFirst && found.count > 0); other = found.nextOf(_way))
            {
                if (_seen.narrowPhase.areTouching(body, table.bodyOf(other)))
                {
                    var toX:Number = table.now.x[other] - body.placement.x;
                    var toY:Number = table.now.y[other] - body.placement.y;
                    var toZ:Number = table.now.z[other] - body.placement.z;
                    // the ground has no place, so it comes last
                    found.add(other, other == RowList.GROUND ? Infinity : toX * toX + toY * toY + toZ * toZ);
                }
            }
            return found;
        }

        /** Throws a RangeError if a number is negative or not a number. */
        public static function requirePositive(name:String, value:Number):void
        {
            if (!(value >= 0))
            {
                throw new RangeError(name + " must not be negative: " + value);
            }
        }
    }
}
