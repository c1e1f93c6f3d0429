package starlogo.collision
{
    import starlogo.agents.Agent;
    import starlogo.data.NumberList;
    import starlogo.engine;
    import starlogo.handlers.CollisionHandler;
    import starlogo.handlers.HandlerTable;
    import starlogo.handlers.PairHandlers;
    import starlogo.handlers.Touch;
    import starlogo.handlers.TouchTracker;
    import starlogo.handlers.nameBreeds;
    import starlogo.search.FoundPairs;

    use namespace engine;

    /** Calls the handlers of a frame: first for touches that have ended, then for the pairs. If a handler throws, the next one is still called. */
    internal final class HandlerCalls
    {
        // The kind of handlers that are called in each frame of a touch, as in HandlerTable.kinds.
        private static const EACH_FRAME:int = 1 << CollisionHandler.COLLISION;

        /** The number of handlers called. */
        public var count:int = 0;

        private var _contacts:FrameContacts = new FrameContacts();
        private var _pairs:FoundPairs = null;
        private var _table:HandlerTable = null;
        private var _tracker:TouchTracker = null;
        private var _list:GameList = new GameList();

        // The pairs whose handlers are called, by their indices; null for all pairs. Whether each pair has got its touch, with calls both ways.
        private var _chosen:NumberList;
        private var _areTouchesComplete:Boolean;

        // The index of the ended touch, or of the pair's turn, that is being called. Its handlers, and the index of the next one. After an error the
        // calls go on from here.
        private var _step:int;
        private var _handlers:PairHandlers;
        private var _next:int;

        // Whether a handler runs. An error of a handler leaves it true.
        private var _isCalling:Boolean = false;

        /**
         * Makes the calls of a frame.
         *
         * @param pairs the pairs of the frame, in the order of their calls
         * @param system has found them
         * @param table the handlers of each pair of breeds
         * @param tracker knows the touching pairs of breeds that have handlers for starts or ends
         * @param agents the game's own list, which handlers may change
         * @param errors receives the errors that handlers throw
         */
        public function make(pairs:FoundPairs, system:BaseCollider, table:HandlerTable, tracker:TouchTracker, agents:Vector.<Agent>,
                errors:Vector.<Error>):void
        {
            _pairs = pairs;
            _table = table;
            _tracker = tracker;
            _list.begin(agents, pairs);
            count = 0;
            _chosen = null;
            _areTouchesComplete = true;
            _contacts.begin(system);
            var compared:NumberList = tracker.pairsToCompare(pairs);
            if (table.contactKinds != 0)
            {
                // before the touches, because a game's own contactOf may throw. Then no touch has changed
                findContacts((table.contactKinds & EACH_FRAME) == 0 ? compared : null);
            }
            var tracksTouches:Boolean = tracker.count > 0 || (table.kinds & ~EACH_FRAME) != 0;
            if (tracksTouches)
            {
                tracker.begin(pairs, compared, table);
                callEnds(errors);
                _chosen = (table.kinds & EACH_FRAME) == 0 ? compared : null;
            }
            callPairs(errors);
            if (tracksTouches)
            {
                tracker.end(pairs, _areTouchesComplete);
            }
            _contacts.end();
            _list.end();
        }

        // Computes the contacts that handlers take, before a handler moves an agent. Null stands for all _pairs.
        private function findContacts(some:NumberList):void
        {
            var end:int = some == null ? _pairs.count : some.count;
            for (var i:int = 0; i < end; i++)
            {
                var pair:int = some == null ? i : some.numbers[i];
                if (_table.handlersOfPair(_pairs, pair).needsContacts)
                {
                    _contacts.find(pair, _pairs.firstOf(pair), _pairs.secondOf(pair));
                }
            }
        }

        // Makes the calls for ended touches. The try is here and in callPairs(), and not around each call, because a method with a try makes an
        // object for each of its calls in Adobe's VM, and takes longer than most handlers.
        private function callEnds(errors:Vector.<Error>):void
        {
            _step = _next = 0;
            while (_step < _tracker.endedCount)
            {
                _isCalling = false;
                try
                {
                    for (; _step < _tracker.endedCount; _step++)
                    {
                        endTouch(_tracker.endedAt(_step));
                        _next = 0;
                    }
                }
                catch (error:*)
                {
                    keepError(error, errors);
                }
            }
        }

        // Makes the calls for the pairs.
        private function callPairs(errors:Vector.<Error>):void
        {
            var end:int = _chosen == null ? _pairs.count : _chosen.count;
            _step = _next = 0;
            while (_step < end)
            {
                _isCalling = false;
                try
                {
                    for (; _step < end; _step++)
                    {
                        takePair(_chosen == null ? _step : _chosen.numbers[_step]);
                        _next = 0;
                    }
                }
                catch (error:*)
                {
                    keepError(error, errors);
                }
            }
        }

        // Keeps the error of a handler, and throws any other. That comes from the computation of a contact, or from the engine, and going on would
        // throw it again.
        private function keepError(error:*, errors:Vector.<Error>):void
        {
            if (!_isCalling)
            {
                throw error;
            }
            errors.push(nameBreeds(error is Error ? error : new Error(String(error)), _handlers.handlers[_next - 1]));
        }

        // The loop is like that of takePair(), because one more call for each pair takes a tenth of a frame in Adobe's VM.
        // The handlers belong to the breeds that the two agents had when the touch began. An ended touch has no contact.
        private function endTouch(touch:Touch):void
        {
            if (_next == 0)
            {
                _handlers = _table.handlersOf(touch.firstBreed, touch.secondBreed);
            }
            var handlers:Vector.<CollisionHandler> = _handlers.handlers;
            var forwardCount:int = _handlers.forwardCount;
            var end:int = touch.isBothWays ? handlers.length : forwardCount;
            while (_next < end)
            {
                var handler:CollisionHandler = handlers[_next];
                _next++;
                if (handler.kind == CollisionHandler.END && !handler.isRemoved)
                {
                    count++;
                    // a local, so that the handler is not called as a method of its CollisionHandler
                    var toCall:Function = handler.callback;
                    var isBack:Boolean = _next > forwardCount;
                    var collider:Agent = isBack ? touch.second : touch.first;
                    var collidee:Agent = isBack ? touch.first : touch.second;
                    _isCalling = true;
                    if (handler.takesContact)
                    {
                        toCall(collider, collidee, null);
                    }
                    else
                    {
                        toCall(collider, collidee);
                    }
                    _isCalling = false;
                }
            }
        }

        // In the first frame of a touch, its handlers for starts are called before those for every frame.
        private function takePair(pair:int):void
        {
            var firstRow:int = _pairs.rows[2 * pair];
            var secondRow:int = _pairs.rows[2 * pair + 1];
            var first:Agent = _pairs.agents[firstRow];
            var second:Agent = _pairs.agents[secondRow];
            if (_next == 0)
            {
                _handlers = _table.handlersOf(first.breedNumber, second.breedNumber);
            }
            var handlers:Vector.<CollisionHandler> = _handlers.handlers;
            var forwardCount:int = _handlers.forwardCount;
            var end:int = handlers.length;
            var touch:Touch = null;
            if (_handlers.tracksTouches)
            {
                touch = touchOf(pair, firstRow, secondRow);
                if (touch == null)
                {
                    _areTouchesComplete = false;
                    return;
                }
            }
            var isStarting:Boolean = touch != null && touch.beganIn == _tracker.frame;
            var next:int = _next;
            while (next < end)
            {
                var handler:CollisionHandler = handlers[next];
                var isMeant:Boolean = handler.kind == CollisionHandler.COLLISION || isStarting && handler.kind == CollisionHandler.START;
                if (isMeant && !_list.hasBoth(firstRow, secondRow))
                {
                    break;
                }
                next++;
                if (!isMeant || handler.isRemoved)
                {
                    continue;
                }
                _next = next;
                var toCall:Function = handler.callback;
                var isBack:Boolean = next > forwardCount;
                var collider:Agent = isBack ? second : first;
                var collidee:Agent = isBack ? first : second;
                var contact:Contact = handler.takesContact ? _contacts.contactFor(pair, first, second, isBack) : null;
                count++;
                _isCalling = true;
                if (handler.takesContact)
                {
                    toCall(collider, collidee, contact);
                }
                else
                {
                    toCall(collider, collidee);
                }
                _isCalling = false;
            }
            if (isStarting)
            {
                touch.isBothWays = next > forwardCount || next == end;
                _areTouchesComplete &&= touch.isBothWays;
            }
        }

        // The touch of a pair, which begins if there is none; null if there is none, and one of the agents has left the list.
        private function touchOf(pair:int, firstRow:int, secondRow:int):Touch
        {
            var touch:Touch = _tracker.touchAt(pair);
            if (touch == null && _list.hasBoth(firstRow, secondRow))
            {
                touch = _tracker.touchOrStartAt(_pairs, pair);
            }
            return touch;
        }
    }
}
