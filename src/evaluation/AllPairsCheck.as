package evaluation
{
    import flash.utils.Dictionary;
    import flash.utils.getTimer;
    import starlogo.agents.Agent;
    import starlogo.collision.CollisionSystem;

    /**
     * Checks a collider against trying all pairs one by one: it must find exactly the same collisions. If there are too many pairs, only
     * some agents, evenly spread over the list, are tried with all others.
     */
    public final class AllPairsCheck
    {
        private static const STEP_MS:int = 30;

        private var _collider:CollisionSystem;
        private var _agents:Vector.<Agent>;
        private var _partners:Dictionary = new Dictionary();
        private var _stride:int;
        private var _next:int = 0;
        private var _agrees:Boolean = true;

        /**
         * @param collider has found the collisions
         * @param agents the agents of the game
         * @param maxPairs the most pairs to try
         */
        public function AllPairsCheck(collider:CollisionSystem, agents:Vector.<Agent>, maxPairs:int)
        {
            _collider = collider;
            _agents = agents;
            _stride = Math.max(1, Math.ceil(agents.length * agents.length / maxPairs));
            var found:Vector.<Agent> = collider.findCollisions(agents);
            for (var i:int = 0; i < found.length; i += 2)
            {
                note(found[i], found[i + 1]);
                note(found[i + 1], found[i]);
            }
        }

        /** Whether both agree so far. */
        public function get agrees():Boolean
        {
            return _agrees;
        }

        /** Tries pairs for a while. Returns whether all are done. */
        public function work():Boolean
        {
            var start:int = getTimer();
            while (_next < _agents.length && getTimer() - start < STEP_MS)
            {
                _agrees = _agrees && isRight(_next);
                _next += _stride;
            }
            return _next >= _agents.length;
        }

        private function note(agent:Agent, other:Agent):void
        {
            _partners[agent] ||= new Dictionary();
            _partners[agent][other] = true;
        }

        // Tries the pairs of an agent. If all agents are tried, the earlier ones have tried their pairs with it.
        private function isRight(index:int):Boolean
        {
            var agent:Agent = _agents[index];
            var partners:Dictionary = _partners[agent] || new Dictionary();
            for (var i:int = _stride == 1 ? index + 1 : 0; i < _agents.length; i++)
            {
                if (_agents[i] !== agent && _collider.areColliding(agent, _agents[i]) != (_agents[i] in partners))
                {
                    return false;
                }
            }
            return true;
        }
    }
}
