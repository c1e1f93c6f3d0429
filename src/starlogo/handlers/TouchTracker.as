package starlogo.handlers
{
    import starlogo.agents.Agent;
    import starlogo.data.IntList;
    import starlogo.data.SortableIntList;
    import starlogo.engine;
    import starlogo.search.FoundPairs;

    use namespace engine;

    /**
     * Compares the pairs of a frame with the touches of the last one: which touches go on, and which end. A frame calls <code>begin()</code> before its
     * handlers, and <code>end()</code> after them. It writes the touches of the pairs to FoundPairs. If a search has replaced few of these pairs since,
     * only the touches of dropped and added pairs are compared. The memory is in proportion to the largest number of pairs that there were.
     *
     * @private
     */
    public final class TouchTracker
    {
        // In place of the index of a touch: the pair has no handlers for starts or ends.
        private static const UNTRACKED:int = FoundPairs.NO_TOUCH - 1;

        /** The number of the frame, from 1 on. */
        public var frame:int = 0;

        /** The touches. Those that have ended in this frame keep their agents until <code>end()</code>. */
        public var touches:TouchTable;

        // The pairs of the frame.
        private var _pairs:FoundPairs = null;

        // The pairs whose touches may begin.
        private var _starting:IntList = new IntList();

        // The indices of the touches that ended in this frame, in the order in which they began.
        private var _ended:SortableIntList = new SortableIntList();

        /** @param touches those of the frames before, which have no numbers here */
        public function TouchTracker(touches:TouchTable)
        {
            this.touches = touches;
        }

        /**
         * Begins a frame. The touches of pairs that touched before go on. The others end.
         *
         * @param table the handlers. A pair without handlers for starts or ends has no touch
         * @return the answer of <code>pairsThatMayStart()</code>
         */
        public function begin(pairs:FoundPairs, table:HandlerTable):IntList
        {
            var starting:IntList = pairsThatMayStart(pairs);
            frame++;
            _pairs = pairs;
            if (starting == null)
            {
                compareAll(table);
            }
            else
            {
                compareSome(starting, table);
            }
            _ended.sortFirst(_ended.count);
            return starting;
        }

        /** The touch of a pair of the frame; null if there is none. */
        public function touchAt(pair:int):Touch
        {
            var index:int = _pairs.touches[pair];
            return index < 0 ? null : touches.all[index];
        }

        /** Gives a pair of the frame the touch of its agents. If there is none, one begins, of the breeds that the two have now. */
        public function findOrStartAt(pair:int):Touch
        {
            var first:Agent = _pairs.firstOf(pair);
            var second:Agent = _pairs.secondOf(pair);
            var touch:Touch = touches.find(first, second) || touches.start(first, second, first.breedNumber, second.breedNumber, frame);
            _pairs.touches[pair] = touch.index;
            return touch;
        }

        /** Lets the touch of a pair end in the next frame, because its handlers were called for the first agent only. A new one may begin there. */
        public function dropAt(pair:int):void
        {
            _pairs.droppedTouches.add(_pairs.touches[pair]);
            _pairs.touches[pair] = FoundPairs.NO_TOUCH;
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
        public function end():void
        {
            for (var i:int = 0; i < _ended.count; i++)
            {
                touches.release(endedAt(i));
            }
            _ended.count = 0;
        }

        /**
         * The pairs whose touches may begin in a frame: those that have none if the touches of all others go on. Null stands for all pairs. Ask before
         * <code>begin()</code>.
         */
        public function pairsThatMayStart(pairs:FoundPairs):IntList
        {
            if (pairs.touchOwner !== this)
            {
                return null;
            }
            _starting.count = 0;
            for (var pair:int = 0; pair < pairs.count; pair++)
            {
                if (pairs.touches[pair] == FoundPairs.NO_TOUCH)
                {
                    _starting.add(pair);
                }
            }
            return _starting;
        }

        /**
         * The touch of a pair that goes on if the two touch in the next frame too; null if there is none. It does not go on if a breed has changed, or
         * if handlers were called for the first agent only.
         */
        public function touchToContinue(pairs:FoundPairs, pair:int):Touch
        {
            var touch:Touch = touches.find(pairs.firstOf(pair), pairs.secondOf(pair));
            return touch != null && touch.isCalledForBoth && touch.firstBreed == touch.first.breedNumber && touch.secondBreed == touch.second.breedNumber
                ? touch : null;
        }

        private function compareAll(table:HandlerTable):void
        {
            if (_pairs.touches.length < _pairs.count)
            {
                // grows by an eighth, because a vector that grows a little in each frame is copied each time
                _pairs.touches.length = _pairs.count + (_pairs.count >> 3);
            }
            for (var pair:int = 0; pair < _pairs.count; pair++)
            {
                continueTouch(pair, table);
            }
            for (var index:int = 0; index < touches.all.length; index++)
            {
                endUnlessContinued(touches.all[index]);
            }
            _pairs.droppedTouches.count = 0;
            _pairs.touchOwner = this;
        }

        private function compareSome(starting:IntList, table:HandlerTable):void
        {
            for (var i:int = 0; i < starting.count; i++)
            {
                continueTouch(starting.values[i], table);
            }
            for (i = 0; i < _pairs.droppedTouches.count; i++)
            {
                endUnlessContinued(touches.all[_pairs.droppedTouches.values[i]]);
            }
            _pairs.droppedTouches.count = 0;
        }

        // Lets the touch of a pair go on, if there is one and the two still have handlers for starts or ends.
        private function continueTouch(pair:int, table:HandlerTable):void
        {
            var isTracked:Boolean = table.handlersOfPair(_pairs, pair).tracksTouches;
            var touch:Touch = isTracked ? touchToContinue(_pairs, pair) : null;
            _pairs.touches[pair] = touch != null ? touch.index : isTracked ? FoundPairs.NO_TOUCH : UNTRACKED;
            if (touch != null)
            {
                touch.lastFrame = frame;
            }
        }

        // Ends a touch that does not go on in this frame.
        private function endUnlessContinued(touch:Touch):void
        {
            if (touch.first != null && touch.lastFrame != frame)
            {
                touches.end(touch);
                _ended.add(touch.index, touch.serial);
            }
        }
    }
}
