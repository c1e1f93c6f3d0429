package starlogo.queries.motion
{
    import flash.geom.Vector3D;
    import starlogo.agents.Agent;
    import starlogo.data.NumberList;
    import starlogo.engine;
    import starlogo.geometry.requireInWorld;
    import starlogo.queries.AgentFilter;
    import starlogo.queries.SeenAgents;
    import starlogo.queries.trees.Collector;
    import starlogo.queries.trees.SweptBoxSearch;
    import starlogo.search.Body;

    use namespace engine;

    /**
     * Prepares the motions of questions: reads the body of an agent that moves, finds the rows near its way, and puts the agent to its new place.
     *
     * @private
     */
    public final class MotionPlanner
    {
        private var _seen:SeenAgents;
        private var _found:Collector;
        private var _search:SweptBoxSearch = new SweptBoxSearch();

        /** @param seen the agents that the questions are about */
        public function MotionPlanner(seen:SeenAgents)
        {
            _seen = seen;
            _found = new Collector(seen);
        }

        /** Whether a filter's <code>accepts</code> is being called. Then this must not plan another motion. */
        public function get isAsking():Boolean
        {
            return _found.isAsking;
        }

        /**
         * Reads the body of an agent that moves, as it is now, turned by some degrees.
         *
         * @throws ArgumentError if the agent is null, has no place, or its model is unknown or lacks data that is needed
         */
        public function readBody(agent:Agent, turn:Number, out:Body):void
        {
            _seen.requirePlaced(agent);
            out.copyFrom(_seen.bodyOf(agent));
            if (turn != 0 && out.shape != null)
            {
                out.turn(agent, turn);
            }
        }

        /**
         * Plans a straight motion: finds the rows near it.
         *
         * @param asker the agent that moves, or null
         * @param out has the body, and receives the rest
         */
        public function plan(asker:Agent, dx:Number, dy:Number, dz:Number, filter:AgentFilter, out:PlannedMotion):void
        {
            setMotion(dx, dy, dz, out);
            if (begin(out))
            {
                _search.moveAlong(dx, dy, dz, 1);
                collectRows(asker, filter, out.rows);
            }
        }

        /** Plans a motion that may turn and go as far as its length in any direction: finds the rows near it. See <code>plan()</code>. */
        public function planSlide(asker:Agent, dx:Number, dy:Number, dz:Number, filter:AgentFilter, out:PlannedMotion):void
        {
            setMotion(dx, dy, dz, out);
            planWithin(asker, Math.sqrt(dx * dx + dy * dy + dz * dz), 0, 0, filter, out);
        }

        /**
         * Plans motions that are not known yet: finds the rows near a body.
         *
         * @param asker the agent that moves
         * @param range how far the body may go in any direction
         * @param up how much farther it may go upwards
         * @param down how much farther it may go downwards
         * @param out has the body, and receives its place and the rows
         */
        public function planWithin(asker:Agent, range:Number, up:Number, down:Number, filter:AgentFilter, out:PlannedMotion):void
        {
            if (begin(out))
            {
                _search.widen(range, up, down);
                collectRows(asker, filter, out.rows);
            }
        }

        /** Asks a filter about one row, as a search of its own. Returns whether the row counts. */
        public function askFilter(row:int, asker:Agent, filter:AgentFilter):Boolean
        {
            return _found.askFilter(row, asker, filter);
        }

        /**
         * Puts an agent to its new place, and turns it by some degrees.
         *
         * @throws ArgumentError if the filter's accepts has removed the agent's model. The agent has then not moved
         */
        public function moveAgent(agent:Agent, at:Vector3D, turn:Number = 0):void
        {
            // throws the error
            _seen.bodyOf(agent);
            agent.moveTo(at.x, at.y, at.z);
            if (turn != 0)
            {
                agent.heading += turn;
            }
            if (_seen.rowOf(agent) >= 0)
            {
                _seen.refresh(agent);
            }
        }

        private static function setMotion(dx:Number, dy:Number, dz:Number, out:PlannedMotion):void
        {
            requireInWorld("a motion", dx, dy, dz);
            out.motion.setTo(dx, dy, dz);
        }

        // Begins without rows. Returns false if the model of the body is loading.
        private function begin(out:PlannedMotion):Boolean
        {
            out.from.setTo(out.body.placement.x, out.body.placement.y, out.body.placement.z);
            out.rows.count = 0;
            if (out.body.shape == null)
            {
                return false;
            }
            _search.beginAround(_seen.treeOfExtents(), out.body);
            return true;
        }

        private function collectRows(asker:Agent, filter:AgentFilter, out:NumberList):void
        {
            _found.begin(Collector.ALL, 1, asker, filter);
            for (var row:int = _found.nextOf(_search); row >= 0; row = _found.nextOf(_search))
            {
                _found.add(row, 0);
            }
            var count:int = _found.endSorted();
            for (var i:int = 0; i < count; i++)
            {
                out.add(_found.rowAt(i));
            }
        }
    }
}
