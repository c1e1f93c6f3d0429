package starlogo.handlers
{
    import starlogo.agents.Agent;
    import starlogo.data.IntList;
    import starlogo.data.SortableIntList;
    import starlogo.engine;
    import starlogo.search.FoundPairs;

    use namespace engine;

    /**
     * Compares the pairs of a frame with the touches of the last one: which touches go on, and which end. A frame calls
     * <code>beginFrame()</code> and <code>endOthers()</code> before its handlers, and <code>release()</code> after them. If the search has only updated the
     * pairs of the last one, kept pairs keep their touches without a look at their agents.
     *
     * @private
     */
    public final class TouchTracker
    {
        // In place of the index of a pair's touch: there is none, or none yet.
        private static const NO_TOUCH:int = -1;

        // In place of a version of pairs: it is not known which touches pairs have.
        private static const NO_VERSION:int = -1;

        /** The number of the frame, from 1 on. */
        public var frame:int = 0;

        /** The touches. Those that have ended in this frame keep their agents until <code>release()</code>. */
        public var touches:TouchTable;

        // The pairs of the frame, and their version.
        private var _pairs:FoundPairs = null;
        private var _version:int = NO_VERSION;

        // By pair: the index of its touch, or NO_TOUCH. There may be more entries than pairs.
        private var _touchOfPair:Vector.<int> = new Vector.<int>();

        // The same for the version before.
        private var _touchOfPairBefore:Vector.<int> = new Vector.<int>();

        // The pairs whose touches may begin.
        private var _starting:IntList = new IntList();

        // The indices of the touches that ended in this frame, in the order in which they began.
        private var _ended:SortableIntList = new SortableIntList();

        /** @param touches those of the frames before. Which pairs they belong to is not known here */
        public function TouchTracker(touches:TouchTable)
        {
            this.touches = touches;
        }

        /**
         * Begins a frame: the touches of pairs that touched before go on. No touch has ended yet.
         *
         * @param table the handlers
         * @return the pairs without a touch, until the next call. Their touches may begin, if they have handlers for starts or ends then
         */
        public function beginFrame(pairs:FoundPairs, table:HandlerTable):IntList
        {
            var isUpdate:Boolean = pairs === _pairs && pairs.isUpdate && pairs.version == _version + 1;
            var before:Vector.<int> = _touchOfPair;
            _touchOfPair = _touchOfPairBefore;
            _touchOfPairBefore = before;
            if (_touchOfPair.length < pairs.count)
            {
                // grows by an eighth, because a vector that grows a little in each frame is copied each time
                _touchOfPair.length = pairs.count + (pairs.count >> 3);
            }
            _pairs = pairs;
            _version = pairs.version;
            frame++;
            _starting.count = 0;
            var lastFrames:Vector.<int> = touches.lastFrames;
            for (var pair:int = 0; pair < pairs.count; pair++)
            {
                var touch:int = isUpdate && pairs.origins[pair] != FoundPairs.NEW ? before[pairs.origins[pair]] : NO_TOUCH;
                if (touch == NO_TOUCH)
                {
                    touch = touchToContinue(pair, table);
                }
                _touchOfPair[pair] = touch;
                if (touch == NO_TOUCH)
                {
                    _starting.add(pair);
                }
                else
                {
                    lastFrames[touch] = frame;
                }
            }
            return _starting;
        }

        /** Ends the touches that do not go on in this frame. */
        public function endOthers():void
        {
            var lastFrames:Vector.<int> = touches.lastFrames;
            for (var index:int = 0; index < lastFrames.length; index++)
            {
                if (lastFrames[index] < frame)
                {
                    touches.end(touches.all[index]);
                    _ended.add(index, touches.all[index].serial);
                }
            }
            _ended.sortFirst(_ended.count);
        }

        /** The number of touches that ended in this frame. */
        public function get endedCount():int
        {
            return _ended.count;
        }

        /** One of the touches that ended in this frame. They are in the order in which they began. */
        public function endedAt(index:int):Touch
        {
            return touches.all[_ended.values[index]];
        }

        /** Ends a frame, also one that has failed: forgets the touches that have ended. */
        public function release():void
        {
            for (var i:int = 0; i < _ended.count; i++)
            {
                touches.release(endedAt(i));
            }
            _ended.count = 0;
        }

        /** The touch of a pair of the frame; null if there is none. */
        public function touchAt(pair:int):Touch
        {
            return _touchOfPair[pair] == NO_TOUCH ? null : touches.all[_touchOfPair[pair]];
        }

        /** Begins the touch of a pair of the frame that has none, of the breeds that the two agents have now. */
        public function startAt(pair:int):Touch
        {
            var first:Agent = _pairs.firstOf(pair);
            var second:Agent = _pairs.secondOf(pair);
            var touch:Touch = touches.start(first, second, first.breedNumber, second.breedNumber, frame);
            _touchOfPair[pair] = touch.index;
            return touch;
        }

        /** Lets the touch of a pair end in the next frame, because its handlers were called for the first agent only. A new one may begin there. */
        public function dropAt(pair:int):void
        {
            _touchOfPair[pair] = NO_TOUCH;
        }

        /** Forgets which touches the pairs have, because the calls of a frame have failed. */
        public function forgetPairs():void
        {
            _version = NO_VERSION;
        }

        // The index of the touch of a pair that goes on; NO_TOUCH if there is none, if a breed has changed, if handlers were called for the first agent
        // only, or if the two have no handlers for starts or ends.
        private function touchToContinue(pair:int, table:HandlerTable):int
        {
            if (!table.handlersOfPair(_pairs, pair).tracksTouches)
            {
                return NO_TOUCH;
            }
            var touch:Touch = touches.find(_pairs.firstOf(pair), _pairs.secondOf(pair));
            var goesOn:Boolean = touch != null && touch.isComplete && touch.firstBreed == touch.first.breedNumber
                && touch.secondBreed == touch.second.breedNumber;
            return goesOn ? touch.index : NO_TOUCH;
        }
    }
}
