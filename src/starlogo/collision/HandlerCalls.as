package starlogo.collision
{
    import starlogo.agents.Agent;
    import starlogo.agents.AgentRecord;
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

        // The pair whose turn it is: whether it was looked up, its agents, and the handlers of its two directions. The latter
        // stay for the next pair of the same breeds.
        private var _isLookedUp:Boolean;
        private var _first:AgentRecord;
        private var _second:AgentRecord;
        private var _breed:int;
        private var _otherBreed:int;
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
            _breed = _otherBreed = -1;
            _handlers = _handlersBack = null;
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
                    if (_handlers != null)
                    {
                        callHandlers(_handlers, _first, _second);
                    }
                    _direction = 1;
                    _handler = 0;
                }
                if (_handlersBack != null)
                {
                    callHandlers(_handlersBack, _second, _first);
                }
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
                if (_direction == 0 && _handlers != null)
                {
                    callHandlers(_handlers, _first, _second);
                }
                else if (_direction == 1 && _handlersBack != null)
                {
                    callHandlers(_handlersBack, _second, _first);
                }
                _isLookedUp = false;
            }
        }

        // The breeds count that the two have now, for all of the pair's calls.
        private function lookUpPair():void
        {
            var list:AgentList = _list;
            var first:AgentRecord = _pairs[_pair].records;
            if (first == null || first.cacheToken !== list.cacheToken || first.frame != list.frame)
            {
                first = list.recordOf(_pairs[_pair]);
            }
            var second:AgentRecord = _pairs[int(_pair + 1)].records;
            if (second == null || second.cacheToken !== list.cacheToken || second.frame != list.frame)
            {
                second = list.recordOf(_pairs[int(_pair + 1)]);
            }
            var interests:BreedInterests = _table.interests;
            var breedToken:Object = interests.token;
            if (first.breedToken !== breedToken)
            {
                interests.lookUp(first);
            }
            if (second.breedToken !== breedToken)
            {
                interests.lookUp(second);
            }
            if (first.breedIndex != _breed || second.breedIndex != _otherBreed)
            {
                lookUpHandlers(first.breedIndex, second.breedIndex);
            }
            _first = first;
            _second = second;
            _direction = 0;
            _handler = 0;
            _isLookedUp = true;
        }

        private function lookUpHandlers(breed:int, otherBreed:int):void
        {
            _breed = breed;
            _otherBreed = otherBreed;
            _handlers = _handlersBack = null;
            if (breed >= 0 && otherBreed >= 0)
            {
                _handlers = _table.handlersOf(breed, otherBreed);
                _handlersBack = _table.handlersOf(otherBreed, breed);
            }
        }

        private function callHandlers(handlers:Vector.<CollisionHandler>, colliderRecord:AgentRecord, collideeRecord:AgentRecord):void
        {
            var agents:Vector.<Agent> = _list.agents;
            var collider:Agent = colliderRecord.agent;
            var collidee:Agent = collideeRecord.agent;
            var handlerCount:int = handlers.length;
            while (_handler < handlerCount)
            {
                // mostly both still are where they were
                if (agents.length != _list.lengthAtStart || agents[colliderRecord.listIndex] !== collider
                        || agents[collideeRecord.listIndex] !== collidee)
                {
                    if (!_list.contains(colliderRecord, count) || !_list.contains(collideeRecord, count))
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
                    handler(collider, collidee);
                }
            }
        }
    }
}
