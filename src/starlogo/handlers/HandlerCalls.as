package starlogo.handlers
{
    import starlogo.agents.Agent;
    import starlogo.engine;
    import starlogo.search.FoundPairs;

    use namespace engine;

    /**
     * Calls the handlers of a frame: first for touches that have ended, then for the pairs. If a handler throws, the next one is still called.
     *
     * @private
     */
    public final class HandlerCalls
    {
        /** The pairs of the frame, in the order of their calls. */
        public var pairs:FoundPairs = new FoundPairs();

        /** The number of handlers called. */
        public var count:int = 0;

        /** Knows the touching pairs of breeds that have handlers for starts or ends. */
        public var tracker:TouchTracker = new TouchTracker();

        /**
         * The agent of the ground, or null, and the agent of the edges, or null. Agents of the list may touch them. Their indices begin
         * after the end of the list.
         */
        public var fixtures:Vector.<Agent> = new <Agent>[null, null];

        private var _contacts:ContactSource;
        private var _table:HandlerTable = null;
        private var _errors:Vector.<Error> = null;

        // The list as it was searched; the same list, which handlers may change; whether all agents asked about were still at their indices.
        private var _listed:Vector.<Agent> = null;
        private var _agents:Vector.<Agent> = null;
        private var _areInPlace:Boolean;
        private var _list:AgentList = new AgentList();

        // For each pair: its touch, or null.
        private var _touches:Vector.<Touch> = new Vector.<Touch>();

        // The number of the turn: negative for ended touches, from 0 on for pairs. The two agents, their indices in the list, and the touch if it
        // begins in this turn.
        private var _turn:int;
        private var _firstAt:int;
        private var _secondAt:int;
        private var _first:Agent;
        private var _second:Agent;
        private var _starting:Touch;

        // The handlers of this turn, how many of them to call, and the next one. While a handler runs, the next one is the one after it.
        private var _handlers:PairHandlers;
        private var _callCount:int;
        private var _call:int;

        /**
         * @param contacts computes the contacts of pairs
         */
        public function HandlerCalls(contacts:ContactSource)
        {
            _contacts = contacts;
        }

        /**
         * Makes the calls of a frame.
         *
         * @param table the handlers of each pair of breeds
         * @param listed the list as it was searched; it does not change
         * @param agents the same list, which handlers may change
         * @param errors receives the errors that handlers throw
         */
        public function make(table:HandlerTable, listed:Vector.<Agent>, agents:Vector.<Agent>, errors:Vector.<Error>):void
        {
            _table = table;
            _listed = listed;
            _agents = agents;
            _errors = errors;
            _areInPlace = true;
            _list.setAgents(agents);
            _turn = _call = count = 0;
            if (!table.isPlain || tracker.count > 0)
            {
                findTouches();
                _turn = -tracker.endedCount;
                takeTurnsBefore(0);
                tracker.forgetEnded();
            }
            takeTurnsBefore(pairs.count);
            _list.end();
            _listed = _agents = null;
            _first = _second = null;
        }

        // Finds which pairs touched before. Computes the contacts that handlers take, before a handler moves an agent.
        private function findTouches():void
        {
            tracker.frame++;
            _contacts.beginFrame(pairs.count);
            for (var pair:int = 0; pair < pairs.count; pair++)
            {
                readAgents(pair);
                var handlers:PairHandlers = _table.handlersOf(_first.breedNumber, _second.breedNumber);
                // the ground and the edges have no rows that keep them as they are, so nothing can be computed later
                if (handlers.takesContacts || _secondAt >= _listed.length && _table.takesFixtureContacts)
                {
                    _contacts.find(pair, _first, _second);
                }
                _touches[pair] = handlers.ofStart == null ? null : tracker.renew(_first, _second);
            }
            tracker.separateEnded();
        }

        // After an error, goes on with the next handler.
        private function takeTurnsBefore(end:int):void
        {
            while (_turn < end)
            {
                var calls:int = count;
                try
                {
                    takeTurns(end);
                }
                catch (error:*)
                {
                    if (count == calls)
                    {
                        // the error does not come from a handler, so calling again would throw it again
                        throw error;
                    }
                    _errors.push(error is Error ? error : new Error(String(error)));
                }
            }
        }

        private function takeTurns(end:int):void
        {
            for (; _turn < end; _turn++)
            {
                if (_call == 0)
                {
                    begin();
                }
                var first:Agent = _first;
                var second:Agent = _second;
                var handlers:Vector.<CollisionHandler> = _handlers.handlers;
                var forwardCount:int = _handlers.forwardCount;
                while (_call < _callCount && (_turn < 0 || areListed()))
                {
                    var handler:CollisionHandler = handlers[_call];
                    _call++;
                    if (handler.isRemoved)
                    {
                        continue;
                    }
                    count++;
                    // a local, so that the handler is not called as a method of its CollisionHandler
                    var toCall:Function = handler.handler;
                    var isBack:Boolean = _call > forwardCount;
                    var collider:Agent = isBack ? second : first;
                    var collidee:Agent = isBack ? first : second;
                    if (handler.takesContact)
                    {
                        // an ended touch has no contact
                        var contact:Object = _turn < 0 ? null : _contacts.contactFor(_turn, first, second, isBack);
                        toCall(collider, collidee, contact);
                    }
                    else
                    {
                        toCall(collider, collidee);
                    }
                }
                if (_starting != null && (_call > forwardCount || _call == _callCount))
                {
                    _starting.isBothWays = true;
                }
                _call = 0;
            }
        }

        private function begin():void
        {
            _starting = null;
            if (_turn < 0)
            {
                beginEnd(tracker.ended[tracker.endedCount + _turn]);
                return;
            }
            readAgents(_turn);
            _handlers = _table.handlersOf(_first.breedNumber, _second.breedNumber);
            _callCount = _handlers.handlers.length;
            if (_handlers.ofStart != null)
            {
                findTouch();
            }
        }

        // The handlers belong to the breeds that the two agents had when the touch began.
        private function beginEnd(touch:Touch):void
        {
            _first = touch.first;
            _second = touch.second;
            _handlers = _table.handlersOf(touch.firstBreed, touch.secondBreed);
            _callCount = 0;
            if (_handlers.ofEnd != null)
            {
                _handlers = _handlers.ofEnd;
                _callCount = touch.isBothWays ? _handlers.handlers.length : _handlers.forwardCount;
            }
        }

        // If the touch begins now, the handlers for starts are called too. It does not begin if an agent has left the list.
        private function findTouch():void
        {
            var touch:Touch = _touches[_turn];
            if (touch == null && areListed())
            {
                touch = _touches[_turn] = tracker.start(_first, _second, _first.breedNumber, _second.breedNumber);
            }
            if (touch == null)
            {
                _callCount = 0;
            }
            else if (touch.beganIn == tracker.frame)
            {
                _starting = touch;
                _handlers = _handlers.ofStart;
                _callCount = _handlers.handlers.length;
            }
        }

        private function readAgents(pair:int):void
        {
            var indices:Vector.<int> = pairs.indices;
            _firstAt = indices[2 * pair];
            _secondAt = indices[2 * pair + 1];
            _first = _listed[_firstAt];
            _second = _secondAt < _listed.length ? _listed[_secondAt] : fixtures[_secondAt - _listed.length];
        }

        // Whether both agents are in the list. Usually they are at their indices. Once one is not, AgentList answers for the rest of the frame.
        private function areListed():Boolean
        {
            var agents:Vector.<Agent> = _agents;
            var isFixture:Boolean = _secondAt >= _listed.length;
            if (_areInPlace && agents.length == _listed.length && agents[_firstAt] === _first && (isFixture || agents[_secondAt] === _second))
            {
                return true;
            }
            _areInPlace = false;
            return _list.contains(_first) && (isFixture || _list.contains(_second));
        }
    }
}
