package starlogo.handlers
{
    import starlogo.agents.Agent;
    import starlogo.engine;
    import starlogo.search.BreedPairs;
    import starlogo.search.FoundPairs;

    use namespace engine;

    /**
     * Calls the handlers of a frame: those of contacts that have ended, then those of the pairs. When one throws, it goes on with the next.
     *
     * <p>The next call is in fields, which are one call ahead while a handler runs: after a handler that throws the next one is called.</p>
     *
     * @private
     */
    public final class HandlerCalls
    {
        // In place of a breed's number, when no pair is at hand.
        private static const NO_PAIRS:int = -2;

        /** The pairs of the frame, in the order of their calls. */
        public var pairs:FoundPairs = new FoundPairs();

        /** How many handlers were called. */
        public var count:int = 0;

        private var _contacts:ContactSource;
        private var _tracker:ContactTracker = new ContactTracker();

        // Whether there are calls of onCollision alone, without contacts; else the tracked contact of each pair, or null.
        private var _isPlain:Boolean;
        private var _contactPairs:Vector.<ContactPair> = new Vector.<ContactPair>();

        private var _table:HandlerTable = null;
        private var _agents:Vector.<Agent> = null;
        private var _errors:Vector.<Error> = null;

        // The next call: of which ended contact, or of which pair, and which of its calls.
        private var _ended:int;
        private var _pair:int;
        private var _call:int;

        // Of the pair at hand: its handlers, by the breeds that it had when its turn came, and its contact if that begins in this frame.
        private var _handlers:PairHandlers;
        private var _starting:ContactPair;

        // The list's length, as long as every agent was in its place; after that -1, and AgentList is asked.
        private var _length:int;
        private var _list:AgentList = new AgentList();

        /**
         * @param contacts knows how pairs touch
         */
        public function HandlerCalls(contacts:ContactSource)
        {
            _contacts = contacts;
        }

        /** Sets the pairs to those of a client's own collision system. There are no calls for an agent that is not in the list. */
        public function setPairs(agentPairs:Vector.<Agent>, agents:Vector.<Agent>):void
        {
            _list.setAgents(agents);
            for (var i:int = 0; i < agentPairs.length; i++)
            {
                pairs.agents[i] = agentPairs[i];
                pairs.places[i] = Math.max(0, _list.placeOf(agentPairs[i]));
            }
            pairs.end(agents.length == 0 ? 0 : agentPairs.length);
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
            _list.setAgents(agents);
            _ended = _pair = _call = count = 0;
            _handlers = table.handlersOf(-1, -1);
            _starting = null;
            _isPlain = table.isPlain && _tracker.count == 0;
            if (!_isPlain)
            {
                prepare();
            }
            callThrough();
            _list.end();
            _agents = null;
        }

        /** Which pairs touch, of breeds with handlers for starts or ends. */
        public function get tracker():ContactTracker
        {
            return _tracker;
        }

        /** @private */
        public function set tracker(value:ContactTracker):void
        {
            _tracker = value;
        }

        // Computes the contacts that handlers take, and finds the pairs that touched before.
        private function prepare():void
        {
            var breedPairs:BreedPairs = _table.breedPairs;
            breedPairs.follow();
            _tracker.frame++;
            _contacts.beginFrame(pairs.length >> 1);
            for (var i:int = 0; i < pairs.length; i += 2)
            {
                var first:Agent = pairs.agents[i];
                var second:Agent = pairs.agents[i + 1];
                var handlers:PairHandlers = _table.handlersOf(breedPairs.numbers[first.breedNumber], breedPairs.numbers[second.breedNumber]);
                if (handlers.takesContacts)
                {
                    _contacts.find(i >> 1, first, second);
                }
                _contactPairs[i >> 1] = handlers.ofStart == null ? null : _tracker.renew(first, second);
            }
            _tracker.separateEnded();
        }

        // Makes the calls from the next one on. If this throws, a handler has thrown.
        private function callThrough():void
        {
            while (true)
            {
                var calls:int = count;
                try
                {
                    callEnds();
                    callPairs();
                    return;
                }
                catch (error:*)
                {
                    if (count == calls)
                    {
                        // not from a handler: it would be thrown again
                        throw error;
                    }
                    _errors.push(error is Error ? error : new Error(String(error)));
                }
            }
        }

        // Calls the handlers of ended contacts, for the breeds that the two had when the contact began.
        private function callEnds():void
        {
            var numbers:Vector.<int> = _table.breedPairs.numbers;
            for (; _ended < _tracker.endedCount; _ended++)
            {
                var pair:ContactPair = _tracker.ended[_ended];
                var ofPair:PairHandlers = _table.handlersOf(numbers[pair.firstBreed], numbers[pair.secondBreed]).ofEnd;
                var callCount:int = ofPair == null ? 0 : (pair.isBothWays ? ofPair.handlers.length : ofPair.forwardCount);
                while (_call < callCount)
                {
                    var handler:CollisionHandler = ofPair.handlers[_call];
                    _call++;
                    if (!handler.isRemoved)
                    {
                        count++;
                        handler.call(pair.first, pair.second, _call > ofPair.forwardCount, null);
                    }
                }
                _call = 0;
            }
            _tracker.forgetEnded();
        }

        private function callPairs():void
        {
            var agents:Vector.<Agent> = _agents;
            var ofPairs:Vector.<Agent> = pairs.agents;
            var places:Vector.<int> = pairs.places;
            var breedPairs:BreedPairs = _table.breedPairs;
            var numbers:Vector.<int> = breedPairs.numbers;
            var known:int = numbers.length;
            var end:int = pairs.length;
            var isPlain:Boolean = _isPlain;
            var call:int = _call;
            var handlers:Vector.<CollisionHandler> = _handlers.handlers;
            var forwardCount:int = _handlers.forwardCount;
            var callCount:int = handlers.length;
            var breed:int = NO_PAIRS;
            var otherBreed:int = NO_PAIRS;
            for (var pair:int = _pair; pair < end; pair += 2)
            {
                _pair = pair;
                var first:Agent = ofPairs[pair];
                var second:Agent = ofPairs[pair + 1];
                if (call == 0)
                {
                    // a handler may have made a new breed
                    if (first.breedNumber >= known || second.breedNumber >= known)
                    {
                        breedPairs.follow();
                        known = numbers.length;
                    }
                    var firstBreed:int = numbers[first.breedNumber];
                    var secondBreed:int = numbers[second.breedNumber];
                    if (firstBreed != breed || secondBreed != otherBreed || !isPlain)
                    {
                        breed = firstBreed;
                        otherBreed = secondBreed;
                        lookUpHandlers(breed, otherBreed);
                        handlers = _handlers.handlers;
                        forwardCount = _handlers.forwardCount;
                        callCount = handlers.length;
                    }
                }
                var firstPlace:int = places[pair];
                var secondPlace:int = places[pair + 1];
                while (call < callCount)
                {
                    // mostly both still are where they were
                    if ((agents.length != _length || agents[firstPlace] !== first || agents[secondPlace] !== second) && !areListed())
                    {
                        break;
                    }
                    var handler:CollisionHandler = handlers[call];
                    call++;
                    if (handler.isRemoved)
                    {
                        continue;
                    }
                    _call = call;
                    count++;
                    var toCall:Function = handler.handler;
                    if (handler.takesContact || handler.maySeeContact)
                    {
                        callWithContact(handler, first, second, call > forwardCount);
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
                if (_starting != null && (call > forwardCount || call == callCount))
                {
                    _starting.isBothWays = true;
                }
                call = 0;
            }
            _pair = end;
            _call = 0;
        }

        private function callWithContact(handler:CollisionHandler, first:Agent, second:Agent, isBack:Boolean):void
        {
            var pair:int = _pair >> 1;
            var contact:Object = handler.takesContact ? _contacts.contactOf(pair, first, second, isBack)
                : _contacts.contactWhenAsked(pair, first, second, isBack);
            handler.call(first, second, isBack, contact);
        }

        // Finds the handlers of the pair's breeds. If they ask for contacts and none goes on, a contact begins: then the handlers are those of a
        // start, or none if an agent has left the list.
        private function lookUpHandlers(breed:int, otherBreed:int):void
        {
            var ofPair:PairHandlers = _table.handlersOf(breed, otherBreed);
            _handlers = ofPair;
            _starting = null;
            if (ofPair.ofStart == null)
            {
                return;
            }
            var contactPair:ContactPair = _contactPairs[_pair >> 1];
            if (contactPair == null)
            {
                if (!areListed())
                {
                    _handlers = _table.handlersOf(-1, -1);
                    return;
                }
                contactPair = _contactPairs[_pair >> 1] = _tracker.start(pairs.agents[_pair], pairs.agents[_pair + 1]);
            }
            if (contactPair.beganIn == _tracker.frame)
            {
                _starting = contactPair;
                _handlers = ofPair.ofStart;
            }
        }

        // Whether both agents of the pair are in the list. Once an agent was not in its place, AgentList is asked for the rest of the frame.
        private function areListed():Boolean
        {
            var first:Agent = pairs.agents[_pair];
            var second:Agent = pairs.agents[_pair + 1];
            if (_agents.length == _length && _agents[pairs.places[_pair]] === first && _agents[pairs.places[_pair + 1]] === second)
            {
                return true;
            }
            _length = -1;
            return _list.contains(first) && _list.contains(second);
        }
    }
}
