package starlogo.collision
{
    import starlogo.agents.Agent;

    /**
     * The touches of a frame's pairs, for those whose handlers ask when they begin and end. The pairs are numbered from 0.
     */
    internal final class FrameTouches
    {
        /** Of each pair; null where nobody asks, or it has not begun. Empty in frames in which nobody asks. */
        public var ofPairs:Vector.<TouchRecord> = new Vector.<TouchRecord>();

        private var _tracker:TouchTracker = new TouchTracker();

        /** Nobody touches anybody. */
        public function FrameTouches()
        {
        }

        /** Whether there are touches that have not ended. */
        public function get hasAny():Boolean
        {
            return _tracker.count > 0;
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

        /** Has the touch of a pair begin, of which one is about to hear. */
        public function start(pair:int, first:Agent, second:Agent):void
        {
            var touch:TouchRecord = _tracker.find(first, second) || _tracker.add(first, second);
            touch.known |= TouchRecord.FIRST;
            ofPairs[pair] = touch;
        }

        /** Whether this is the first frame of a pair's touch. */
        public function isFirst(pair:int):Boolean
        {
            var touch:TouchRecord = ofPairs[pair];
            return touch != null && touch.beganIn == _tracker.frame;
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
            var count:int = 0;
            var ended:Vector.<TouchRecord> = _tracker.ended;
            for (var i:int = 0; i < ended.length; i++)
            {
                var touch:TouchRecord = ended[i];
                if ((touch.known & TouchRecord.FIRST) != 0)
                {
                    count += callAll(table.handlersFrom(touch.firstBreed, touch.secondBreed), touch.first, touch.second, errors);
                }
                if ((touch.known & TouchRecord.SECOND) != 0)
                {
                    count += callAll(table.handlersFrom(touch.secondBreed, touch.firstBreed), touch.second, touch.first, errors);
                }
            }
            _tracker.forgetEnded();
            return count;
        }

        private static function callAll(handlers:Vector.<CollisionHandler>, collider:Agent, collidee:Agent, errors:Vector.<Error>):int
        {
            var count:int = 0;
            for each (var handler:CollisionHandler in handlers)
            {
                if (handler.kind == CollisionHandler.END && !handler.isRemoved)
                {
                    count++;
                    try
                    {
                        call(handler, collider, collidee);
                    }
                    catch (error:*)
                    {
                        errors.push(error is Error ? error : new Error(String(error)));
                    }
                }
            }
            return count;
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
