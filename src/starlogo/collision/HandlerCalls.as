package starlogo.collision
{
    import starlogo.agents.Agent;
    import starlogo.engine;

    use namespace engine;

    /**
     * Calls the handlers of a frame's pairs, and goes on after one that throws.
     *
     * <p>The next call is in fields: its pair, its direction and its handler. They are one ahead while a handler runs, so that
     * after one that throws the next one's turn has come.</p>
     */
    internal final class HandlerCalls
    {
        /** How many handlers were called. */
        public var count:int = 0;

        private var _list:AgentList = new AgentList();
        private var _table:HandlerTable = null;
        private var _pairs:Vector.<Agent> = null;
        private var _errors:Vector.<Error> = null;
        private var _pair:int;
        private var _direction:int;
        private var _handler:int;

        // The pair whose turn it is: whether it was looked up, its agents, and the handlers of its two directions.
        private var _isLookedUp:Boolean;
        private var _first:ListedAgent;
        private var _second:ListedAgent;
        private var _handlers:Vector.<CollisionHandler>;
        private var _handlersBack:Vector.<CollisionHandler>;

        // Calls that were put off because an agent was in doubt: pair, direction, handler of each. Of the ones before, those
        // whose turn it is now, or null.
        private var _postponed:Vector.<int> = new Vector.<int>();
        private var _turns:Vector.<int> = null;
        private var _turn:int;

        /** No calls yet. */
        public function HandlerCalls()
        {
        }

        /**
         * Makes the calls of a frame.
         *
         * @param table says which
         * @param pairs of agents that collide, in the order of the calls
         * @param agents the list, which handlers may change
         * @param errors takes what handlers throw
         */
        public function make(table:HandlerTable, pairs:Vector.<Agent>, agents:Vector.<Agent>, errors:Vector.<Error>):void
        {
            count = 0;
            if (agents.length == 0)
            {
                return;
            }
            _table = table;
            _pairs = pairs;
            _errors = errors;
            _pair = 0;
            _isLookedUp = false;
            _postponed.length = 0;
            _turns = null;
            _list.begin(agents);
            callThrough();
            while (_postponed.length > 0 && agents.length > 0)
            {
                _turns = _postponed;
                _turn = 0;
                _postponed = new Vector.<int>();
                _list.begin(agents);
                callThrough();
            }
            letGo();
        }

        private function letGo():void
        {
            _table = null;
            _pairs = null;
            _errors = null;
            _turns = null;
            _first = _second = null;
            _handlers = _handlersBack = null;
            _list.end();
        }

        // Each time that it throws, a handler has thrown.
        private function callThrough():void
        {
            var hasMore:Boolean = true;
            while (hasMore)
            {
                var calls:int = count;
                try
                {
                    callRest();
                    hasMore = false;
                }
                catch (error:*)
                {
                    if (count == calls)
                    {
                        // not a handler's: it would come again
                        throw error;
                    }
                    _errors.push(error is Error ? error : new Error(String(error)));
                }
            }
        }

        private function callRest():void
        {
            if (_turns != null)
            {
                callPostponed();
                return;
            }
            for (; _pair < _pairs.length; _pair += 2)
            {
                if (!_isLookedUp)
                {
                    lookUpPair();
                }
                if (_direction == 0)
                {
                    callHandlers(_handlers, _first, _second);
                    _direction = 1;
                    _handler = 0;
                }
                callHandlers(_handlersBack, _second, _first);
                _isLookedUp = false;
            }
        }

        private function callPostponed():void
        {
            for (; _turn < _turns.length; _turn += 3)
            {
                if (!_isLookedUp)
                {
                    _pair = _turns[_turn];
                    lookUpPair();
                    _direction = _turns[int(_turn + 1)];
                    _handler = _turns[int(_turn + 2)];
                }
                if (_direction == 0)
                {
                    callHandlers(_handlers, _first, _second);
                }
                else
                {
                    callHandlers(_handlersBack, _second, _first);
                }
                _isLookedUp = false;
            }
        }

        // The breeds count that the two have now, for all of the pair's calls.
        private function lookUpPair():void
        {
            var first:ListedAgent = _list.recordOf(_pairs[_pair]);
            var second:ListedAgent = _list.recordOf(_pairs[int(_pair + 1)]);
            var interests:BreedInterests = _table.interests;
            if (first.breedToken !== interests.token)
            {
                interests.lookUp(first);
            }
            if (second.breedToken !== interests.token)
            {
                interests.lookUp(second);
            }
            _handlers = _handlersBack = null;
            if (first.breedIndex >= 0 && second.breedIndex >= 0)
            {
                _handlers = _table.handlersOf(first.breedIndex, second.breedIndex);
                _handlersBack = _table.handlersOf(second.breedIndex, first.breedIndex);
            }
            _first = first;
            _second = second;
            _direction = 0;
            _handler = 0;
            _isLookedUp = true;
        }

        private function callHandlers(handlers:Vector.<CollisionHandler>, collider:ListedAgent, collidee:ListedAgent):void
        {
            if (handlers == null)
            {
                return;
            }
            var agents:Vector.<Agent> = _list.agents;
            var length:int = _list.lengthAtStart;
            var handlerCount:int = handlers.length;
            while (_handler < handlerCount)
            {
                // mostly both still are where they were
                if (agents.length != length || agents[collider.listIndex] !== collider.agent || agents[collidee.listIndex] !== collidee.agent)
                {
                    if (!_list.contains(collider, count) || !_list.contains(collidee, count))
                    {
                        if (_list.isInDoubt)
                        {
                            _postponed.push(_pair, _direction, _handler);
                        }
                        return;
                    }
                }
                var next:CollisionHandler = handlers[_handler];
                _handler++;
                if (!next.isRemoved)
                {
                    count++;
                    var handler:Function = next.handler;
                    handler(collider.agent, collidee.agent);
                }
            }
        }
    }
}
