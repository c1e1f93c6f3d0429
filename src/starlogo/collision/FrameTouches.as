package starlogo.collision
{
    import starlogo.agents.Agent;
    import starlogo.agents.AgentRecord;
    import starlogo.engine;

    use namespace engine;

    /**
     * The touches of a frame's pairs, for those whose handlers ask when they begin and end. The pairs are numbered from 0.
     */
    internal final class FrameTouches
    {
        /** Of each pair; null where nobody asks, or it has not begun. Empty in frames in which nobody asks. */
        public var ofPairs:Vector.<TouchRecord> = new Vector.<TouchRecord>();

        private var _tracker:TouchTracker = new TouchTracker();

        // The next call of those of ends, and how many there were.
        private var _end:int;
        private var _call:int;
        private var _count:int;

        /** Nobody touches anybody. */
        public function FrameTouches()
        {
        }

        /** Whether there are touches that have not ended. */
        public function get hasAny():Boolean
        {
            return _tracker.count > 0;
        }

        /** The number of the frame, in which the touches of this one began. */
        public function get frame():int
        {
            return _tracker.frame;
        }

        /** Begins a frame: no touch goes on. */
        public function begin(pairCount:int):void
        {
            ofPairs.length = pairCount;
            _tracker.frame++;
        }

        /** Lets go of the pairs. */
        public function end():void
        {
            ofPairs.length = 0;
        }

        /** Has the touch of a pair go on, if there is one. Of other breeds, or one that not both have heard of, has ended. */
        public function goOn(pair:int, a:Agent, b:Agent):void
        {
            var touch:TouchRecord = _tracker.find(a, b);
            if (touch != null && touch.known == (TouchRecord.FIRST | TouchRecord.SECOND) && touch.firstBreed == touch.first.breed
                    && touch.secondBreed == touch.second.breed)
            {
                touch.seenIn = _tracker.frame;
                ofPairs[pair] = touch;
            }
        }

        /** Has the touch of a pair begin, of which one is about to hear; their breeds were looked up. */
        public function start(pair:int, first:AgentRecord, second:AgentRecord):void
        {
            var touch:TouchRecord = _tracker.find(first.agent, second.agent) || _tracker.add(first.agent, second.agent);
            touch.known |= TouchRecord.FIRST;
            touch.firstIndex = first.breedIndex;
            touch.secondIndex = second.breedIndex;
            touch.breedToken = first.breedToken;
            ofPairs[pair] = touch;
        }

        /**
         * Calls those who ask for the ends of the touches that do not go on.
         *
         * @param table says who does
         * @param errors takes what handlers throw
         * @return how many were called
         */
        public function callEnds(table:HandlerTable, errors:Vector.<Error>):int
        {
            _tracker.takeEnded();
            _end = _call = _count = 0;
            var hasMore:Boolean = _tracker.ended.length > 0;
            while (hasMore)
            {
                var calls:int = _count;
                try
                {
                    callRest(table);
                    hasMore = false;
                }
                catch (error:*)
                {
                    if (_count == calls)
                    {
                        // not a handler's: it would come again
                        throw error;
                    }
                    errors.push(error is Error ? error : new Error(String(error)));
                }
            }
            _tracker.forgetEnded();
            return _count;
        }

        // From the next call on: it is one ahead while a handler runs.
        private function callRest(table:HandlerTable):void
        {
            var ended:Vector.<TouchRecord> = _tracker.ended;
            for (; _end < ended.length; _end++)
            {
                var touch:TouchRecord = ended[_end];
                var pair:PairHandlers = handlersOf(touch, table);
                while (_call < pair.endHandlers.length)
                {
                    var handler:CollisionHandler = pair.endHandlers[_call];
                    var isBack:Boolean = _call >= pair.endForwardCount;
                    var who:int = isBack ? TouchRecord.SECOND : TouchRecord.FIRST;
                    _call++;
                    if (handler.isRemoved || (touch.known & who) == 0)
                    {
                        continue;
                    }
                    _count++;
                    call(handler, isBack ? touch.second : touch.first, isBack ? touch.first : touch.second);
                }
                _call = 0;
            }
        }

        // For the breeds that they had when it began.
        private static function handlersOf(touch:TouchRecord, table:HandlerTable):PairHandlers
        {
            var interests:BreedInterests = table.interests;
            if (touch.breedToken !== interests.token)
            {
                touch.firstIndex = interests.indexOf(touch.firstBreed);
                touch.secondIndex = interests.indexOf(touch.secondBreed);
            }
            return table.handlersOf(touch.firstIndex, touch.secondIndex);
        }

        private static function call(handler:CollisionHandler, collider:Agent, collidee:Agent):void
        {
            var toCall:Function = handler.handler;
            if (handler.takesContact)
            {
                toCall(collider, collidee, null);
            }
            else
            {
                toCall(collider, collidee);
            }
        }
    }
}
