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
    internal final class HandlerCalls
    {
        // In place of the index of a pair: a touch that has ended.
        private static const NO_PAIR:int = -1;

        // In place of the index of the next handler: the calls of a pair or touch have not begun.
        private static const NOT_BEGUN:int = -1;

        private var _contacts:FrameContacts = new FrameContacts();
        private var _pairs:FoundPairs = null;
        private var _table:HandlerTable = null;
        private var _gameList:GameList = new GameList();

        // Knows the touches; null if there are none and no handler is for starts or ends.
        private var _tracker:TouchTracker = null;

        // The handlers of the present pair or ended touch.
        private var _ofPair:PairHandlers;

        // The index of the next of these handlers, or NOT_BEGUN. If a handler throws, the calls go on from here.
        private var _next:int;

        // Whether a handler runs.
        private var _isCalling:Boolean;

        // The number of handlers called.
        private var _count:int = 0;

        /**
         * Makes the calls of a frame. Call <code>end()</code> afterwards.
         *
         * @param pairs the pairs of the frame, in the order of their calls
         * @param system has found them
         * @param table the handlers of each pair of breeds
         * @param tracker knows the touching pairs of breeds that have handlers for starts or ends
         * @param agents the game's own list, which handlers may change
         * @param errors receives the errors that handlers throw
         * @return the number of handlers called
         */
        public function make(pairs:FoundPairs, system:BaseCollider, table:HandlerTable, tracker:TouchTracker, agents:Vector.<Agent>,
                errors:Vector.<Error>):int
        {
            _pairs = pairs;
            _table = table;
            _gameList.begin(agents);
            _count = 0;
            _tracker = tracker.touches.count > 0 || table.tracksTouches ? tracker : null;
            var starting:IntList = _tracker == null ? null : tracker.findStarting(pairs, table);
            if (table.contactKinds != 0)
            {
                // before touches end, because a game's own contactOf may throw. Then the next frame ends them
                _contacts.setTo(system, pairs);
                findContacts(starting);
            }
            if (_tracker != null)
            {
                tracker.endOthers();
            }
            callAll((table.kinds & CollisionHandler.COLLISION) == 0 ? starting : null, errors);
            return _count;
        }

        /** Ends the calls of a frame, also if <code>make()</code> has thrown an error or was not called. */
        public function end():void
        {
            if (_tracker != null)
            {
                _tracker.release();
                _tracker = null;
            }
        }

        // Computes the contacts that handlers take, before a handler moves an agent. Handlers for starts take none of a touch that goes on.
        private function findContacts(starting:IntList):void
        {
            var chosen:IntList = (_table.contactKinds & CollisionHandler.COLLISION) == 0 ? starting : null;
            var end:int = chosen == null ? _pairs.count : chosen.count;
            for (var i:int = 0; i < end; i++)
            {
                var pair:int = chosen == null ? i : chosen.values[i];
                var kinds:int = _table.handlersOfPair(_pairs, pair).contactKinds;
                if ((kinds & CollisionHandler.COLLISION) != 0 || kinds != 0 && _tracker.touchAt(pair) == null)
                {
                    _contacts.find(pair);
                }
            }
        }

        // Makes all calls: for the touches that have ended, then for the chosen pairs. Null stands for all pairs. The try is here and not around each
        // call, because a method with a try makes an object for each of its calls in Adobe's VM, and takes longer than most handlers.
        private function callAll(chosen:IntList, errors:Vector.<Error>):void
        {
            var ended:int = _tracker == null ? 0 : _tracker.endedCount;
            var pairCount:int = chosen == null ? _pairs.count : chosen.count;
            var end:int = ended + pairCount;
            var done:int = 0;
            _next = NOT_BEGUN;
            _isCalling = false;
            while (done < end)
            {
                try
                {
                    for (; done < end; done++)
                    {
                        if (done < ended)
                        {
                            callForEnded(_tracker.endedAt(done));
                        }
                        else
                        {
                            callForPair(chosen == null ? done - ended : chosen.values[done - ended]);
                        }
                        _next = NOT_BEGUN;
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
                if (_tracker != null)
                {
                    // the present pair may have got its touch without all calls
                    _tracker.forgetPairs();
                }
                throw error;
            }
            _isCalling = false;
            errors.push(nameBreeds(error is Error ? error : new Error(String(error)), _ofPair.handlers[_next - 1]));
        }

        // The handlers belong to the breeds that the two agents had when the touch began.
        private function callForEnded(touch:Touch):void
        {
            if (_next == NOT_BEGUN)
            {
                _ofPair = _table.handlersOf(touch.firstBreed, touch.secondBreed);
                _next = 0;
            }
            callHandlers(NO_PAIR, touch.first, touch.second, CollisionHandler.END, touch.isCalledForBoth ? _ofPair.handlers.length : _ofPair.firstCount);
        }

        // The handlers belong to the breeds that the two agents have before the first of them is called.
        private function callForPair(pair:int):void
        {
            var first:Agent = _pairs.firstOf(pair);
            var second:Agent = _pairs.secondOf(pair);
            if (_next == NOT_BEGUN)
            {
                _ofPair = _table.handlersOf(first.breedNumber, second.breedNumber);
                _next = 0;
            }
            var end:int = _ofPair.handlers.length;
            if (!_ofPair.tracksTouches)
            {
                callHandlers(pair, first, second, CollisionHandler.COLLISION, end);
                return;
            }
            var touch:Touch = touchOf(pair);
            if (touch == null)
            {
                return;
            }
            var isStarting:Boolean = touch.firstFrame == _tracker.frame;
            callHandlers(pair, first, second, isStarting ? CollisionHandler.COLLISION | CollisionHandler.START : CollisionHandler.COLLISION, end);
            if (isStarting)
            {
                touch.isCalledForBoth = _next > _ofPair.firstCount || _next == end;
                if (!touch.isCalledForBoth)
                {
                    _tracker.dropAt(pair);
                }
            }
        }

        // The touch of a pair, which begins if there is none; null if there is none, and one of the agents has left the list.
        private function touchOf(pair:int):Touch
        {
            var touch:Touch = _tracker.touchAt(pair);
            if (touch == null && _gameList.hasBoth(_pairs, pair))
            {
                touch = _tracker.findOrStartAt(pair);
            }
            return touch;
        }

        // Calls the handlers of the kinds from _next on, up to an index. In the first frame of a touch, those for starts come before those for every
        // frame. An ended touch has no contact, and its agents may have left the list: pass NO_PAIR. For a pair it stops when one of the two has left.
        private function callHandlers(pair:int, first:Agent, second:Agent, kinds:int, end:int):void
        {
            var handlers:Vector.<CollisionHandler> = _ofPair.handlers;
            var firstCount:int = _ofPair.firstCount;
            while (_next < end)
            {
                var handler:CollisionHandler = handlers[_next];
                var isMeant:Boolean = (handler.kind & kinds) != 0;
                if (isMeant && pair != NO_PAIR && !_gameList.hasBoth(_pairs, pair))
                {
                    return;
                }
                var isSecondCollider:Boolean = _next >= firstCount;
                _next++;
                if (isMeant && !handler.isRemoved)
                {
                    call(handler, pair, first, second, isSecondCollider);
                }
            }
        }

        private function call(handler:CollisionHandler, pair:int, first:Agent, second:Agent, isSecondCollider:Boolean):void
        {
            var collider:Agent = isSecondCollider ? second : first;
            var collidee:Agent = isSecondCollider ? first : second;
            var contact:Contact = handler.takesContact && pair != NO_PAIR ? _contacts.contactFor(pair, isSecondCollider) : null;
            // a local, so that the handler is not called as a method of its CollisionHandler
            var toCall:Function = handler.callback;
            _count++;
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
    }
}
