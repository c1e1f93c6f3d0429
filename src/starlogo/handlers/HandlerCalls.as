package starlogo.handlers
{
    import starlogo.agents.Agent;
    import starlogo.engine;
    import starlogo.search.BreedPairs;
    import starlogo.search.FoundPairs;

    use namespace engine;

    /**
     * Calls the handlers of a frame's pairs, and goes on after one that throws: those of the ends of touches, those of the pairs, and
     * those that were put off.
     *
     * <p>The next call is in fields, its pair and which of the pair's calls it is: they are one ahead while a handler runs, so
     * that after one that throws the next one's turn has come.</p>
     *
     * @private
     */
    public final class HandlerCalls
    {
        /** The pairs of the frame, in the order of their calls. */
        public var pairs:FoundPairs = new FoundPairs();

        /** How many handlers were called. */
        public var count:int = 0;

        private var _contacts:ContactSource;
        private var _touches:ContactTracker = new ContactTracker();

        // Whether there are calls of onCollision alone, without contacts; else the touch of each pair, null where none is tracked.
        private var _isPlain:Boolean;
        private var _touchOf:Vector.<ContactPair> = new Vector.<ContactPair>();

        private var _table:HandlerTable = null;
        private var _agents:Vector.<Agent> = null;
        private var _errors:Vector.<Error> = null;

        // The next call: of which end of a touch, or of which pair, those before _end being on.
        private var _ended:int;
        private var _pair:int;
        private var _end:int;
        private var _call:int;

        // The handlers of the breeds that the pair had when its turn came.
        private var _handlers:PairHandlers;

        // The pairs' breeds are those of this count of changes. When it has moved, the names of the breeds that were looked up last.
        private var _breedChanges:int;
        private var _name:String;
        private var _otherName:String;

        // The list's length for as long as every agent was seen in its place; then -1, and the list is asked.
        private var _length:int;
        private var _list:AgentList = new AgentList();

        // Calls that were put off because an agent was in doubt: pair and call of each. Before _knownTo the list was looked at anew.
        private var _postponed:Vector.<int> = new Vector.<int>();
        private var _postponedCount:int;
        private var _turn:int;
        private var _knownTo:int;

        /**
         * @param contacts knows how pairs touch
         */
        public function HandlerCalls(contacts:ContactSource)
        {
            _contacts = contacts;
        }

        /** Takes the pairs that a client's system has found. There are no calls for an agent that is not in the list. */
        public function takePairs(found:Vector.<Agent>, agents:Vector.<Agent>, breedPairs:BreedPairs):void
        {
            _list.begin(agents);
            for (var i:int = 0; i < found.length; i++)
            {
                pairs.agents[i] = found[i];
                pairs.places[i] = Math.max(0, _list.placeOf(found[i]));
                pairs.breeds[i] = breedPairs.numberOf(found[i].breed);
            }
            pairs.end(agents.length == 0 ? 0 : found.length);
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
            _list.begin(agents);
            _breedChanges = Agent.breedChanges;
            _name = _otherName = null;
            _ended = _pair = _call = count = 0;
            _end = pairs.length;
            _handlers = table.handlersOf(-1, -1);
            _postponedCount = _turn = _knownTo = 0;
            _isPlain = table.isPlain && _touches.count == 0;
            if (!_isPlain)
            {
                prepare();
            }
            callThrough();
            _list.end();
            _agents = null;
        }

        // Finds the contacts that are asked for, and the touches that go on.
        private function prepare():void
        {
            _touches.frame++;
            _contacts.begin(pairs.length >> 1);
            for (var i:int = 0; i < pairs.length; i += 2)
            {
                var first:Agent = pairs.agents[i];
                var second:Agent = pairs.agents[i + 1];
                var handlers:PairHandlers = _table.handlersOf(pairs.breeds[i], pairs.breeds[i + 1]);
                if (handlers.takesContacts)
                {
                    _contacts.find(i >> 1, first, second);
                }
                _touchOf[i >> 1] = handlers.ofStart == null ? null : _touches.goOn(first, second);
            }
            _touches.takeEnded();
        }

        // From the next call on. Each time that it throws, a handler has thrown.
        private function callThrough():void
        {
            while (true)
            {
                var calls:int = count;
                try
                {
                    callEnds();
                    callPairs();
                    callPostponed();
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

        // For the breeds that the two had when the touch began.
        private function callEnds():void
        {
            var breedPairs:BreedPairs = _table.breedPairs;
            for (; _ended < _touches.endedCount; _ended++)
            {
                var touch:ContactPair = _touches.ended[_ended];
                var breed:int = breedPairs.numberOf(touch.firstBreed);
                var ofPair:PairHandlers = _table.handlersOf(breed, breedPairs.numberOf(touch.secondBreed)).ofEnd;
                var callCount:int = ofPair == null ? 0 : (touch.isBothWays ? ofPair.handlers.length : ofPair.forwardCount);
                while (_call < callCount)
                {
                    var handler:CollisionHandler = ofPair.handlers[_call];
                    _call++;
                    if (!handler.isRemoved)
                    {
                        count++;
                        var isBack:Boolean = _call > ofPair.forwardCount;
                        handler.call(isBack ? touch.second : touch.first, isBack ? touch.first : touch.second, null);
                    }
                }
                _call = 0;
            }
            _touches.forgetEnded();
        }

        private function callPairs():void
        {
            var agents:Vector.<Agent> = _agents;
            var ofPairs:Vector.<Agent> = pairs.agents;
            var places:Vector.<int> = pairs.places;
            var breeds:Vector.<int> = pairs.breeds;
            var breedChanges:int = _breedChanges;
            var isPlain:Boolean = _isPlain;
            var call:int = _call;
            var made:int = count;
            var length:int = _length;
            var end:int = _end;
            // of no pair
            var breed:int = -2;
            var otherBreed:int = -2;
            var ofPair:PairHandlers = _handlers;
            var handlers:Vector.<CollisionHandler> = ofPair.handlers;
            var forwardCount:int = ofPair.forwardCount;
            var callCount:int = handlers.length;
            for (var pair:int = _pair; pair < end; pair += 2)
            {
                _pair = pair;
                if (call == 0)
                {
                    if (breeds[pair] != breed || breeds[pair + 1] != otherBreed || Agent.breedChanges != breedChanges)
                    {
                        lookUpHandlers();
                        breed = breeds[pair];
                        otherBreed = breeds[pair + 1];
                        ofPair = _handlers;
                        handlers = ofPair.handlers;
                        forwardCount = ofPair.forwardCount;
                        callCount = handlers.length;
                    }
                }
                var first:Agent = ofPairs[pair];
                var second:Agent = ofPairs[pair + 1];
                var firstPlace:int = places[pair];
                var secondPlace:int = places[pair + 1];
                if (!isPlain)
                {
                    var touch:ContactPair = _touchOf[pair >> 1];
                    if (touch == null && ofPair.ofStart != null)
                    {
                        var isListed:Boolean = areListed(first, second, call);
                        length = _length;
                        if (!isListed)
                        {
                            continue;
                        }
                        touch = _touchOf[pair >> 1] = _touches.start(first, second);
                    }
                    var isStart:Boolean = touch != null && touch.beganIn == _touches.frame;
                    var now:PairHandlers = isStart && ofPair.ofStart != null ? ofPair.ofStart : ofPair;
                    handlers = now.handlers;
                    forwardCount = now.forwardCount;
                    callCount = handlers.length;
                }
                while (call < callCount)
                {
                    // mostly both still are where they were
                    if (agents.length != length || agents[firstPlace] !== first || agents[secondPlace] !== second)
                    {
                        length = -1;
                        if (!areListed(first, second, call))
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
                        var isBack:Boolean = call > forwardCount;
                        var contact:Object = _contacts.contactOf(pair >> 1, first, second, isBack);
                        handler.call(isBack ? second : first, isBack ? first : second, contact);
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
                if (!isPlain)
                {
                    if (isStart)
                    {
                        touch.isBothWays = touch.isBothWays || call > forwardCount || call == callCount;
                    }
                }
                call = 0;
            }
            _pair = end;
            _call = 0;
        }

        // The breeds count that the two have now, for all of the pair's calls.
        private function lookUpHandlers():void
        {
            var breeds:Vector.<int> = pairs.breeds;
            if (Agent.breedChanges != _breedChanges)
            {
                var name:String = pairs.agents[_pair].breed;
                var otherName:String = pairs.agents[_pair + 1].breed;
                if (name == _name && otherName == _otherName)
                {
                    return;
                }
                _name = name;
                _otherName = otherName;
                breeds[_pair] = _table.breedPairs.numberOf(name);
                breeds[_pair + 1] = _table.breedPairs.numberOf(otherName);
            }
            _handlers = _table.handlersOf(breeds[_pair], breeds[_pair + 1]);
        }

        // Asks the list, from now on for the rest of the frame.
        private function areListed(first:Agent, second:Agent, call:int):Boolean
        {
            if (_agents.length == _length && _agents[pairs.places[_pair]] === first && _agents[pairs.places[_pair + 1]] === second)
            {
                return true;
            }
            _length = -1;
            if (_list.contains(first) && _list.contains(second))
            {
                return true;
            }
            if (_list.isInDoubt)
            {
                _postponed[_postponedCount] = _pair;
                _postponed[_postponedCount + 1] = call;
                _postponedCount += 2;
            }
            return false;
        }

        private function callPostponed():void
        {
            while (_turn < _postponedCount)
            {
                if (_turn == _knownTo)
                {
                    _list.look();
                    _knownTo = _postponedCount;
                }
                _pair = _postponed[_turn];
                _call = _postponed[_turn + 1];
                _end = _pair + 2;
                _turn += 2;
                lookUpHandlers();
                callPairs();
            }
        }
    }
}
