package starlogo.collision
{
    import starlogo.agents.Agent;
    import starlogo.agents.AgentRecord;
    import starlogo.engine;

    use namespace engine;

    /**
     * Calls the handlers of a frame's pairs, and goes on after one that throws.
     *
     * <p>The next call is in fields, its pair and which of the pair's calls it is: they are one ahead while a handler runs, so
     * that after one that throws the next one's turn has come.</p>
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
        private var _call:int;

        // The handlers of the breeds that the pair had when its turn came.
        private var _breed:int;
        private var _otherBreed:int;
        private var _handlers:PairHandlers;

        // The list's length for as long as nobody was seen to have left his place; then -1, and the list is asked.
        private var _length:int;
        private var _list:AgentList = new AgentList();

        // Calls that were put off because an agent was in doubt: pair and call of each. Of the ones before, those whose turn it
        // is now, or null.
        private var _postponed:Vector.<int> = new Vector.<int>();
        private var _turns:Vector.<int> = null;
        private var _turn:int;
        private var _touches:FrameTouches = new FrameTouches();
        private var _contacts:FrameContacts = new FrameContacts();

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
            for (var i:int = 0; i < found.length; i++)
            {
                pairs[i] = _list.recordOf(found[i]);
            }
            pairs.length = found.length;
        }

        /**
         * Makes the calls of a frame.
         *
         * @param table says which
         * @param agents the list, which handlers may change
         * @param errors takes what handlers throw
         * @param system has found the pairs, and may know their contacts
         */
        public function make(table:HandlerTable, agents:Vector.<Agent>, errors:Vector.<Error>, system:CollisionSystem):void
        {
            _table = table;
            _agents = agents;
            _errors = errors;
            _length = agents.length;
            _list.end();
            _pair = _call = count = 0;
            _breed = _otherBreed = -1;
            _handlers = table.handlersOf(-1, -1);
            _postponed.length = 0;
            _turns = null;
            if (table.tracks || _touches.hasAny || table.takesContacts)
            {
                prepare(table.tracks || _touches.hasAny, system);
            }
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
            _handlers = null;
            _touches.end();
            _contacts.end();
            _list.end();
        }

        // Finds the contacts that are asked for, and the touches that go on; calls those who ask for the ends of the others.
        private function prepare(tracks:Boolean, system:CollisionSystem):void
        {
            var length:int = pairs.length;
            if (tracks)
            {
                _touches.begin(length >> 1);
            }
            _contacts.begin(system, _table.takesContacts ? length >> 1 : 0);
            for (_pair = 0; _pair < length; _pair += 2)
            {
                lookUpHandlers();
                if (_handlers.takesContacts)
                {
                    _contacts.find(_pair >> 1, pairs[_pair], pairs[int(_pair + 1)]);
                }
                if (_handlers.tracks)
                {
                    _touches.goOn(_pair >> 1, pairs[_pair].agent, pairs[int(_pair + 1)].agent);
                }
            }
            _pair = 0;
            if (tracks)
            {
                count += _touches.callEnds(_table, _errors);
            }
        }

        // Each time that it throws, a handler has thrown.
        private function callThrough():void
        {
            while (true)
            {
                var calls:int = count;
                try
                {
                    callRest();
                    return;
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
            if (_turns == null)
            {
                callPairs(pairs.length);
                return;
            }
            while (_turn < _turns.length)
            {
                if (_call == 0)
                {
                    _pair = _turns[_turn];
                    lookUpHandlers();
                    _call = _turns[int(_turn + 1)];
                }
                // one that throws has had its turn
                callPairs(_pair + 2);
                _turn += 2;
            }
        }

        // From the next call on, those of the pairs before this one.
        private function callPairs(end:int):void
        {
            var records:Vector.<AgentRecord> = pairs;
            var agents:Vector.<Agent> = _agents;
            var breedToken:Object = _table.interests.token;
            var touches:Vector.<TouchRecord> = _touches.ofPairs;
            var isTracking:Boolean = touches.length > 0;
            var frame:int = _touches.frame;
            var call:int = _call;
            var made:int = count;
            var length:int = _length;
            var breed:int = _breed;
            var otherBreed:int = _otherBreed;
            var ofPair:PairHandlers = _handlers;
            var handlers:Vector.<CollisionHandler> = ofPair.handlers;
            var forwardCount:int = ofPair.forwardCount;
            var callCount:int = handlers.length;
            for (var pair:int = _pair; pair < end; pair += 2)
            {
                _pair = pair;
                var record:AgentRecord = records[pair];
                var other:AgentRecord = records[int(pair + 1)];
                if (call == 0)
                {
                    if (record.breedToken !== breedToken || other.breedToken !== breedToken || record.breedIndex != breed
                            || other.breedIndex != otherBreed)
                    {
                        lookUpHandlers();
                        breed = _breed;
                        otherBreed = _otherBreed;
                        ofPair = _handlers;
                        handlers = ofPair.handlers;
                        forwardCount = ofPair.forwardCount;
                        callCount = handlers.length;
                    }
                }
                var first:Agent = record.agent;
                var second:Agent = other.agent;
                var firstIndex:int = record.listIndex;
                var secondIndex:int = other.listIndex;
                if (firstIndex >= length || secondIndex >= length)
                {
                    // the list has changed, or a handler has had the collider search another one
                    length = _length = -1;
                }
                var isFirst:Boolean = false;
                if (isTracking)
                {
                    if (ofPair.tracks && touches[pair >> 1] == null)
                    {
                        if (agents.length != length || agents[firstIndex] !== first || agents[secondIndex] !== second)
                        {
                            _call = 0;
                            length = -1;
                            if (!areListed(first, second))
                            {
                                continue;
                            }
                        }
                        _touches.start(pair >> 1, record, other);
                    }
                    var touch:TouchRecord = touches[pair >> 1];
                    isFirst = touch != null && touch.beganIn == frame;
                    handlers = isFirst ? ofPair.firstHandlers : ofPair.handlers;
                    forwardCount = isFirst ? ofPair.firstForwardCount : ofPair.forwardCount;
                    callCount = handlers.length;
                }
                while (call < callCount)
                {
                    // mostly both still are where they were
                    if (agents.length != length || agents[firstIndex] !== first || agents[secondIndex] !== second)
                    {
                        _call = call;
                        length = -1;
                        if (!areListed(first, second))
                        {
                            break;
                        }
                    }
                    var handler:CollisionHandler = handlers[call];
                    call++;
                    if (handler.isRemoved)
                    {
                        continue;
                    }
                    _call = call;
                    made++;
                    count = made;
                    var toCall:Function = handler.handler;
                    if (handler.takesContact)
                    {
                        callWithContact(toCall, record, other, call > forwardCount);
                    }
                    else if (call > forwardCount)
                    {
                        toCall(second, first);
                    }
                    else
                    {
                        toCall(first, second);
                    }
                }
                if (isFirst && (call > forwardCount || call == callCount))
                {
                    touch.known |= TouchRecord.SECOND;
                }
                call = 0;
            }
            _pair = end;
            _call = 0;
        }

        private function callWithContact(toCall:Function, first:AgentRecord, second:AgentRecord, isBack:Boolean):void
        {
            var collider:AgentRecord = isBack ? second : first;
            var collidee:AgentRecord = isBack ? first : second;
            toCall(collider.agent, collidee.agent, _contacts.contactOf(_pair >> 1, first, second, isBack));
        }

        // The breeds count that the two have now, for all of the pair's calls.
        private function lookUpHandlers():void
        {
            var first:AgentRecord = pairs[_pair];
            var second:AgentRecord = pairs[int(_pair + 1)];
            var interests:BreedInterests = _table.interests;
            if (first.breedToken !== interests.token)
            {
                interests.lookUp(first);
            }
            if (second.breedToken !== interests.token)
            {
                interests.lookUp(second);
            }
            _breed = first.breedIndex;
            _otherBreed = second.breedIndex;
            _handlers = _table.handlersOf(_breed, _otherBreed);
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
                _postponed.push(_pair, _call);
            }
            return false;
        }
    }
}
