package starlogo.collision
{
    import starlogo.agents.Agent;
    import starlogo.data.IntList;
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
    internal final class HandlerDispatcher
    {
        // In place of the index of a pair: a touch that has ended.
        private static const NO_PAIR:int = -1;

        private var _table:HandlerTable;
        private var _contacts:FrameContacts = new FrameContacts();
        private var _gameList:GameList = new GameList();

        // Of the last frame: its pairs, the system that has found them, and what knows the touches. Null before the first frame.
        private var _pairs:FoundPairs = null;
        private var _system:BaseCollider = null;
        private var _tracker:TouchTracker = null;

        // All handlers of the present pair or ended touch, or null before its calls begin; the index of the next one; and the one that runs, or null. They
        // stay until the last call, even if one changes a breed. If one throws, callAll comes back to the same pair, whose calls go on at the next index.
        private var _handlersOfPair:PairHandlers = null;
        private var _nextHandler:int;
        private var _running:CollisionHandler = null;

        // The number of handlers called.
        private var _callCount:int = 0;

        /** @param table the handlers of each pair of breeds */
        public function HandlerDispatcher(table:HandlerTable)
        {
            _table = table;
        }

        /**
         * Calls the handlers of a frame. Call <code>endFrame()</code> afterwards.
         *
         * @param pairs the pairs of the frame, in the order of their calls
         * @param system has found them
         * @param tracker knows the touching pairs of breeds that have handlers for starts or ends
         * @param agents the game's own list, which handlers may change
         * @param errors receives the errors that handlers throw
         * @return the number of handlers called
         */
        public function callHandlers(pairs:FoundPairs, system:BaseCollider, tracker:TouchTracker, agents:Vector.<Agent>, errors:Vector.<Error>):int
        {
            _pairs = pairs;
            _system = system;
            _gameList.begin(agents, pairs.listed);
            _callCount = 0;
            _tracker = tracker;
            var starting:IntList = tracker.beginFrame(pairs, _table);
            if (_table.contactPhases != 0)
            {
                // before touches end, because a game's own contactOf may throw. Then the next frame ends them
                _contacts.begin();
                findContacts(starting);
            }
            tracker.endLostTouches();
            callAll((_table.phases & CollisionHandler.EVERY_FRAME) == 0 ? starting : null, errors);
            return _callCount;
        }

        /** Ends the calls of a frame, also if <code>callHandlers()</code> has thrown an error or was not called. */
        public function endFrame():void
        {
            if (_tracker != null)
            {
                _tracker.endFrame();
            }
        }

        // Computes the contacts that handlers take, before a handler moves an agent. Handlers for starts take none of a touch that goes on.
        private function findContacts(starting:IntList):void
        {
            var chosen:IntList = (_table.contactPhases & CollisionHandler.EVERY_FRAME) == 0 ? starting : null;
            var end:int = chosen == null ? _pairs.count : chosen.count;
            for (var i:int = 0; i < end; i++)
            {
                var pair:int = chosen == null ? i : chosen.values[i];
                var phases:int = _table.handlersOfPair(_pairs, pair).contactPhases;
                if ((phases & CollisionHandler.EVERY_FRAME) != 0 || phases != 0 && _tracker.touchAt(pair) == null)
                {
                    _contacts.compute(pair, _pairs, _system);
                }
            }
        }

        // Makes all calls: for the ended touches, then for chosen pairs. Null stands for all pairs. The try is around the loop and not around each call,
        // because a method with a try makes an object for each of its calls in Adobe's VM, and takes longer than most handlers. So an error leaves the loop,
        // which then comes back to the same pair.
        private function callAll(chosen:IntList, errors:Vector.<Error>):void
        {
            var endedCount:int = _tracker.endedCount;
            var pairCount:int = chosen == null ? _pairs.count : chosen.count;
            var end:int = endedCount + pairCount;
            var i:int = 0;
            _handlersOfPair = null;
            _nextHandler = 0;
            while (i < end)
            {
                try
                {
                    for (; i < end; i++)
                    {
                        if (i < endedCount)
                        {
                            callForEnded(_tracker.endedAt(i));
                        }
                        else
                        {
                            callForPair(chosen == null ? i - endedCount : chosen.values[i - endedCount]);
                        }
                        _handlersOfPair = null;
                        _nextHandler = 0;
                    }
                }
                catch (error:*)
                {
                    keepOrRethrow(error, errors);
                }
            }
        }

        // Keeps what a handler has thrown, and throws anything else. That comes from the computation of a contact, or from the engine, and going on would
        // throw it again.
        private function keepOrRethrow(thrown:*, errors:Vector.<Error>):void
        {
            if (_running == null)
            {
                // the present pair may have got its touch without all calls
                _tracker.forgetPairs();
                throw thrown;
            }
            errors.push(nameBreeds(thrown, _running));
            _running = null;
        }

        private function callForEnded(touch:Touch):void
        {
            _handlersOfPair ||= _table.handlersOf(touch.firstBreed, touch.secondBreed);
            var end:int = touch.hasReachedSecond ? _handlersOfPair.handlers.length : _handlersOfPair.splitIndex;
            callRemaining(NO_PAIR, touch.first, touch.second, CollisionHandler.END, end);
        }

        private function callForPair(pair:int):void
        {
            var first:Agent = _pairs.firstOf(pair);
            var second:Agent = _pairs.secondOf(pair);
            _handlersOfPair ||= _table.handlersOf(first.breedNumber, second.breedNumber);
            var end:int = _handlersOfPair.handlers.length;
            if (!_handlersOfPair.tracksTouches)
            {
                callRemaining(pair, first, second, CollisionHandler.EVERY_FRAME, end);
                return;
            }
            var touch:Touch = _tracker.touchAt(pair);
            if (touch == null)
            {
                if (!_gameList.findBoth(_pairs, pair))
                {
                    return;
                }
                touch = _tracker.startAt(pair);
            }
            // a touch of an earlier frame that has not reached the second agent has ended
            var isStarting:Boolean = !touch.hasReachedSecond;
            callRemaining(pair, first, second, isStarting ? CollisionHandler.EVERY_FRAME | CollisionHandler.START : CollisionHandler.EVERY_FRAME, end);
            if (isStarting)
            {
                touch.hasReachedSecond = _nextHandler > _handlersOfPair.splitIndex || _nextHandler == end;
                if (!touch.hasReachedSecond)
                {
                    _tracker.dropAt(pair);
                }
            }
        }

        // Calls the remaining handlers of the phases, up to an index. In the first frame of a touch, those for starts come before those for every
        // frame. An ended touch has no contact, and its agents may have left the list: pass NO_PAIR. For a pair it stops when one of the two has left.
        private function callRemaining(pair:int, first:Agent, second:Agent, phases:int, end:int):void
        {
            var handlers:Vector.<CollisionHandler> = _handlersOfPair.handlers;
            var splitIndex:int = _handlersOfPair.splitIndex;
            while (_nextHandler < end)
            {
                var handler:CollisionHandler = handlers[_nextHandler];
                var isOfPhases:Boolean = (handler.phase & phases) != 0;
                if (isOfPhases && pair != NO_PAIR && !_gameList.findBoth(_pairs, pair))
                {
                    return;
                }
                var isSecondCollider:Boolean = _nextHandler >= splitIndex;
                _nextHandler++;
                if (isOfPhases && !handler.isRemoved)
                {
                    call(handler, pair, first, second, isSecondCollider);
                }
            }
        }

        private function call(handler:CollisionHandler, pair:int, first:Agent, second:Agent, isSecondCollider:Boolean):void
        {
            var collider:Agent = isSecondCollider ? second : first;
            var collidee:Agent = isSecondCollider ? first : second;
            var contact:Contact = handler.takesContact && pair != NO_PAIR ? _contacts.contactFor(pair, isSecondCollider, _pairs, _system) : null;
            // a local, so that the handler is not called as a method of its CollisionHandler
            var toCall:Function = handler.callback;
            _callCount++;
            _running = handler;
            if (handler.takesContact)
            {
                toCall(collider, collidee, contact);
            }
            else
            {
                toCall(collider, collidee);
            }
            _running = null;
        }
    }
}
