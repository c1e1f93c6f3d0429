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
        /** The pairs of the frame, in the order of their calls: records that tell where an agent is in the list, or most likely is. */
        public var pairs:Vector.<AgentRecord> = new Vector.<AgentRecord>();

        /** How many handlers were called. */
        public var count:int = 0;

        private var _table:HandlerTable = null;
        private var _agents:Vector.<Agent> = null;
        private var _errors:Vector.<Error> = null;
        private var _pair:int;
        private var _direction:int;
        private var _handler:int;

        // The pair whose turn it is: whether it was looked up, its agents and their places in the list, and the handlers of its
        // two directions. The latter stay for the next pair of the same breeds.
        private var _isLookedUp:Boolean;
        private var _first:Agent;
        private var _second:Agent;
        private var _firstIndex:int;
        private var _secondIndex:int;
        private var _breed:int;
        private var _otherBreed:int;
        private var _handlers:Vector.<CollisionHandler>;
        private var _handlersBack:Vector.<CollisionHandler>;

        // The list's length for as long as nobody was seen to have left his place; then -1, and the list is asked.
        private var _length:int;
        private var _list:AgentList = new AgentList();

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
         * Takes the pairs that a client's system has found.
         *
         * @param found the agents of each pair
         * @param agents the list
         */
        public function takePairs(found:Vector.<Agent>, agents:Vector.<Agent>):void
        {
            _list.begin(agents);
            var length:int = found.length;
            for (var i:int = 0; i < length; i++)
            {
                pairs[i] = _list.recordOf(found[i]);
            }
            pairs.length = length;
        }

        /**
         * Makes the calls of a frame.
         *
         * @param table says which
         * @param agents the list, which handlers may change
         * @param errors takes what handlers throw
         */
        public function make(table:HandlerTable, agents:Vector.<Agent>, errors:Vector.<Error>):void
        {
            _table = table;
            _agents = agents;
            _errors = errors;
            _length = agents.length;
            _list.end();
            _pair = 0;
            _isLookedUp = false;
            _breed = _otherBreed = -1;
            _handlers = _handlersBack = null;
            _postponed.length = 0;
            _turns = null;
            count = 0;
            callThrough();
            while (_postponed.length > 0)
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
            _agents = null;
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
            for (; _pair < pairs.length; _pair += 2)
            {
                if (!_isLookedUp)
                {
                    lookUpPair();
                }
                if (_direction == 0)
                {
                    if (_handlers != null)
                    {
                        callHandlers(_handlers, _first, _second, _firstIndex, _secondIndex);
                    }
                    _direction = 1;
                    _handler = 0;
                }
                if (_handlersBack != null)
                {
                    callHandlers(_handlersBack, _second, _first, _secondIndex, _firstIndex);
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
                    callHandlers(_handlers, _first, _second, _firstIndex, _secondIndex);
                }
                else if (_direction == 1 && _handlersBack != null)
                {
                    callHandlers(_handlersBack, _second, _first, _secondIndex, _firstIndex);
                }
                _isLookedUp = false;
            }
        }

        // The breeds count that the two have now, for all of the pair's calls.
        private function lookUpPair():void
        {
            var first:AgentRecord = pairs[_pair];
            var second:AgentRecord = pairs[int(_pair + 1)];
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
            _first = first.agent;
            _second = second.agent;
            _firstIndex = first.listIndex;
            _secondIndex = second.listIndex;
            if (_firstIndex >= _length || _secondIndex >= _length)
            {
                // the list has changed, or a handler has had the collider search another one
                _length = -1;
            }
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

        private function callHandlers(handlers:Vector.<CollisionHandler>, collider:Agent, collidee:Agent, colliderIndex:int,
                collideeIndex:int):void
        {
            var agents:Vector.<Agent> = _agents;
            var handlerCount:int = handlers.length;
            while (_handler < handlerCount)
            {
                // mostly both still are where they were
                if (agents.length != _length || agents[colliderIndex] !== collider || agents[collideeIndex] !== collidee)
                {
                    if (!areListed(collider, collidee))
                    {
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

        // Asks the list, from now on for the rest of the frame.
        private function areListed(collider:Agent, collidee:Agent):Boolean
        {
            _length = -1;
            if (!_list.isBegun)
            {
                _list.begin(_agents);
            }
            if (_list.contains(collider, count) && _list.contains(collidee, count))
            {
                return true;
            }
            if (_list.isInDoubt)
            {
                _postponed.push(_pair, _direction, _handler);
            }
            return false;
        }
    }
}
