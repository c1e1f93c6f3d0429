package starlogo.handlers
{
    import starlogo.agents.Agent;
    import starlogo.data.IntList;
    import starlogo.data.IntSet;
    import starlogo.data.IntPairMap;
    import starlogo.data.SortableIntList;
    import starlogo.engine;
    import starlogo.search.FoundPairs;

    use namespace engine;

    /**
     * Keeps the touches of a Collision from frame to frame, and finds which of them begin, go on and end. A frame calls
     * <code>beginFrame()</code> and <code>endLostTouches()</code> before its handlers, and <code>endFrame()</code> after them. If the search has only
     * updated the pairs of the last one, kept pairs keep their touches without a look at their agents. Objects of ended touches are used again, so it
     * allocates nothing unless there are more touches than before.
     *
     * @private
     */
    public final class TouchTracker
    {
        // By index: all touches that there are, and objects for later ones, which have no agents.
        private var _all:Vector.<Touch> = new Vector.<Touch>();

        // The indices of the touches that began or went on in this frame. It is no field of Touch, because a loop over a list is faster.
        private var _present:IntSet = new IntSet();

        // By the ids of the first and of the second agent: the index of their touch.
        private var _indices:IntPairMap = new IntPairMap();

        // The indices of the objects for later touches.
        private var _free:IntList = new IntList();

        // The number of touches that ever began.
        private var _startedCount:Number = 0;

        // The pairs of the frame; null if it is not known which touches they have.
        private var _pairs:FoundPairs = null;

        // The pairs whose touches may begin.
        private var _starting:IntList = new IntList();

        // The indices of the touches that ended in this frame, in the order in which they began. They keep their agents until endFrame().
        private var _ended:SortableIntList = new SortableIntList();

        /**
         * Begins a frame: the touches of pairs that touched before go on. No touch has ended yet. If there are no touches, and no handler is for starts
         * or ends, it does not look at the pairs.
         *
         * @param table the handlers
         * @return the pairs without a touch, until the next call. Their touches may begin, if they have handlers for starts or ends then
         */
        public function beginFrame(pairs:FoundPairs, table:HandlerTable):IntList
        {
            _starting.count = 0;
            if (count == 0 && (table.phases & ~CollisionHandler.EVERY_FRAME) == 0)
            {
                return _starting;
            }
            if (pairs !== _pairs)
            {
                pairs.forgetTouches();
                _pairs = pairs;
            }
            _present.clear(_all.length);
            var marks:Vector.<int> = _present.marks;
            var mark:int = _present.mark;
            var touchIndices:Vector.<int> = pairs.touchIndices;
            for (var pair:int = 0; pair < pairs.count; pair++)
            {
                if (touchIndices[pair] == FoundPairs.NO_TOUCH)
                {
                    touchIndices[pair] = indexToContinue(pair, table);
                }
                if (touchIndices[pair] == FoundPairs.NO_TOUCH)
                {
                    _starting.add(pair);
                }
                else
                {
                    marks[touchIndices[pair]] = mark;
                }
            }
            return _starting;
        }

        /** Ends the lost touches: those that do not go on in this frame. */
        public function endLostTouches():void
        {
            var marks:Vector.<int> = _present.marks;
            var mark:int = _present.mark;
            for (var index:int = 0; index < _all.length; index++)
            {
                // objects without a touch are not present either
                if (marks[index] != mark && _all[index].first != null)
                {
                    var touch:Touch = _all[index];
                    _indices.remove(touch.first.idNumber, touch.second.idNumber);
                    _ended.add(index, touch.order);
                }
            }
            _ended.sortFirst(_ended.count);
        }

        /** The number of touches that have not ended. */
        public function get count():int
        {
            return _all.length - _free.count - _ended.count;
        }

        /** The number of touches that ended in this frame. */
        public function get endedCount():int
        {
            return _ended.count;
        }

        /** One of the touches that ended in this frame. They are in the order in which they began. */
        public function endedAt(index:int):Touch
        {
            return _all[_ended.values[index]];
        }

        /** Ends a frame, also one that has failed: forgets the touches that have ended. */
        public function endFrame():void
        {
            for (var i:int = 0; i < _ended.count; i++)
            {
                var touch:Touch = endedAt(i);
                touch.first = touch.second = null;
                _free.add(touch.index);
            }
            _ended.count = 0;
        }

        /** The touch of two agents, in either order; null if there is none. */
        public function find(a:Agent, b:Agent):Touch
        {
            var index:int = _indices.find(a.idNumber, b.idNumber);
            if (index < 0)
            {
                index = _indices.find(b.idNumber, a.idNumber);
            }
            return index < 0 ? null : _all[index];
        }

        /** The touch of a pair of the frame; null if there is none. */
        public function touchAt(pair:int):Touch
        {
            var index:int = _pairs.touchIndices[pair];
            return index == FoundPairs.NO_TOUCH ? null : _all[index];
        }

        /** Begins the touch of a pair of the frame that has none, of the breeds that the two agents have now. */
        public function startAt(pair:int):Touch
        {
            var first:Agent = _pairs.firstOf(pair);
            var second:Agent = _pairs.secondOf(pair);
            var touch:Touch = start(first, second, first.breedNumber, second.breedNumber);
            _pairs.touchIndices[pair] = touch.index;
            return touch;
        }

        /** Begins a touch of two agents that have none, of these breeds. No handler has been called for it. */
        public function start(first:Agent, second:Agent, firstBreed:int, secondBreed:int):Touch
        {
            var touch:Touch = newTouch();
            touch.first = first;
            touch.second = second;
            touch.firstBreed = firstBreed;
            touch.secondBreed = secondBreed;
            touch.hasReachedSecond = false;
            touch.order = _startedCount;
            _present.add(touch.index);
            _startedCount++;
            _indices.set (first.idNumber, second.idNumber, touch.index);
            return touch;
        }

        /** Lets the touch of a pair end in the next frame, because its handlers were called for the first agent only. A new one may begin there. */
        public function dropAt(pair:int):void
        {
            _pairs.touchIndices[pair] = FoundPairs.NO_TOUCH;
        }

        /** Forgets which touches the pairs have, because the calls of a frame have failed. */
        public function forgetPairs():void
        {
            _pairs = null;
        }

        /** Returns all touches, in the order in which they began. Call it between two frames. */
        public function inOrder():Vector.<Touch>
        {
            var indices:SortableIntList = new SortableIntList();
            for (var i:int = 0; i < _all.length; i++)
            {
                if (_all[i].first != null)
                {
                    indices.add(i, _all[i].order);
                }
            }
            indices.sortFirst(indices.count);
            var ordered:Vector.<Touch> = new Vector.<Touch>();
            for (i = 0; i < indices.count; i++)
            {
                ordered.push(_all[indices.values[i]]);
            }
            return ordered;
        }

        private function newTouch():Touch
        {
            if (_free.count > 0)
            {
                _free.count--;
                return _all[_free.values[_free.count]];
            }
            var touch:Touch = new Touch();
            touch.index = _all.push(touch) - 1;
            _present.grow(_all.length);
            return touch;
        }

        // The index of the touch of a pair that goes on; NO_TOUCH if there is none, if a breed has changed, if handlers were called for the first agent
        // only, or if the two have no handlers for starts or ends.
        private function indexToContinue(pair:int, table:HandlerTable):int
        {
            if (!table.handlersOfPair(_pairs, pair).tracksTouches)
            {
                return FoundPairs.NO_TOUCH;
            }
            var touch:Touch = find(_pairs.firstOf(pair), _pairs.secondOf(pair));
            var goesOn:Boolean = touch != null && touch.hasReachedSecond && touch.firstBreed == touch.first.breedNumber
                && touch.secondBreed == touch.second.breedNumber;
            return goesOn ? touch.index : FoundPairs.NO_TOUCH;
        }
    }
}
