package starlogo.handlers
{
    import starlogo.agents.Agent;
    import starlogo.data.HashTable;
    import starlogo.data.IntList;
    import starlogo.data.SortableIntList;
    import starlogo.engine;
    import starlogo.search.FoundPairs;

    use namespace engine;

    /**
     * Keeps the touches of a Collision from frame to frame: the touch of each pair. A frame calls <code>begin()</code> before its handlers, and
     * <code>end()</code> after them. If its pairs are those of the last frame with few changes, only the touches of dropped and added pairs are
     * compared. Objects of ended touches are used again, so a frame allocates nothing unless there are more touches than before. The memory is in
     * proportion to the largest number of pairs that there were.
     *
     * @private
     */
    public final class TouchTracker
    {
        /** The number of the frame, from 1 on. */
        public var frame:int = 0;

        // By index: all touches that there are, and objects for later ones.
        private var _all:Vector.<Touch> = new Vector.<Touch>();

        // By the ids of two agents, the lesser first: the index of their touch.
        private var _indices:HashTable = new HashTable();

        // The indices of the objects for later touches.
        private var _free:IntList = new IntList();

        // The number of touches that ever began.
        private var _begun:Number = 0;

        // The indices of the touches that ended in this frame, in the order in which they began.
        private var _ended:SortableIntList = new SortableIntList();

        /** The number of touches that have not ended. */
        public function get count():int
        {
            return _all.length - _free.count - _ended.count;
        }

        /**
         * The pairs whose touches may be others than in the last frame: the added ones if all others go on. Null stands for all pairs. Ask before
         * <code>begin()</code>.
         */
        public function pairsToCompare(pairs:FoundPairs):IntList
        {
            return pairs.trackerBefore === this ? pairs.added : null;
        }

        /**
         * Begins a frame. The touches of pairs that touched before go on. The others end.
         *
         * @param compared the answer of <code>pairsToCompare()</code>
         * @param table the handlers. A pair without handlers for starts or ends has no touch
         */
        public function begin(pairs:FoundPairs, compared:IntList, table:HandlerTable):void
        {
            frame++;
            if (compared == null)
            {
                compareAll(pairs, table);
            }
            else
            {
                compareSome(pairs, compared, table);
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
            return _all[_ended.numbers[index]];
        }

        /**
         * Ends a frame, also one that has failed: forgets the touches that have ended.
         *
         * @param areComplete whether each pair with handlers for starts or ends has got its touch, both ways
         */
        public function end(pairs:FoundPairs, areComplete:Boolean):void
        {
            for (var i:int = 0; i < _ended.count; i++)
            {
                var touch:Touch = endedAt(i);
                touch.first = touch.second = null;
                _free.add(touch.index);
            }
            _ended.count = 0;
            pairs.tracker = areComplete ? this : null;
        }

        /** The touch of a pair; null if there is none. */
        public function touchAt(pairs:FoundPairs, pair:int):Touch
        {
            var index:int = pairs.touches[pair];
            return index == FoundPairs.NONE ? null : _all[index];
        }

        /** Gives a pair the touch of its agents. If there is none, one begins, of the breeds that the two have now. */
        public function touchOrStartAt(pairs:FoundPairs, pair:int):Touch
        {
            var first:Agent = pairs.firstOf(pair);
            var second:Agent = pairs.secondOf(pair);
            var touch:Touch = touchOrStart(first, second, first.breedNumber, second.breedNumber);
            pairs.touches[pair] = touch.index;
            return touch;
        }

        /** Finds the touch of two agents. If there is none, one begins, of these breeds. */
        public function touchOrStart(first:Agent, second:Agent, firstBreed:int, secondBreed:int, isBothWays:Boolean = false):Touch
        {
            var index:int = indexOf(first, second);
            var touch:Touch = index < 0 ? newTouch() : _all[index];
            if (index < 0)
            {
                touch.first = first;
                touch.second = second;
                touch.firstBreed = firstBreed;
                touch.secondBreed = secondBreed;
                touch.isBothWays = isBothWays;
                _indices.set (Math.min(first.idNumber, second.idNumber), Math.max(first.idNumber, second.idNumber), touch.index);
            }
            return touch;
        }

        /** Returns all touches, in the order in which they began. Call it between two frames. */
        public function inOrder():Vector.<Touch>
        {
            var order:SortableIntList = new SortableIntList();
            for (var i:int = 0; i < _all.length; i++)
            {
                if (_all[i].first != null)
                {
                    order.add(i, _all[i].serial);
                }
            }
            order.sortFirst(order.count);
            var ordered:Vector.<Touch> = new Vector.<Touch>();
            for (i = 0; i < order.count; i++)
            {
                ordered.push(_all[order.numbers[i]]);
            }
            return ordered;
        }

        private function compareAll(pairs:FoundPairs, table:HandlerTable):void
        {
            pairs.clearTouches();
            for (var pair:int = 0; pair < pairs.count; pair++)
            {
                renew(pairs, pair, table);
            }
            for (var index:int = 0; index < _all.length; index++)
            {
                endUnlessSeen(_all[index]);
            }
        }

        private function compareSome(pairs:FoundPairs, added:IntList, table:HandlerTable):void
        {
            for (var i:int = 0; i < added.count; i++)
            {
                renew(pairs, added.numbers[i], table);
            }
            var dropped:IntList = pairs.droppedTouches;
            for (i = 0; i < dropped.count; i++)
            {
                endUnlessSeen(_all[dropped.numbers[i]]);
            }
        }

        private function newTouch():Touch
        {
            var touch:Touch;
            if (_free.count > 0)
            {
                _free.count--;
                touch = _all[_free.numbers[_free.count]];
            }
            else
            {
                touch = new Touch();
                touch.index = _all.push(touch) - 1;
            }
            touch.beganIn = touch.seenIn = frame;
            touch.serial = _begun;
            _begun++;
            return touch;
        }

        // Lets the touch of a pair go on, if there is one. It does not go on if the two have no handlers for starts or ends, if a breed has changed, or
        // if handlers were called for the first agent only.
        private function renew(pairs:FoundPairs, pair:int, table:HandlerTable):void
        {
            var index:int = table.handlersOfPair(pairs, pair).tracksTouches ? indexOf(pairs.firstOf(pair), pairs.secondOf(pair)) : -1;
            if (index < 0)
            {
                return;
            }
            var touch:Touch = _all[index];
            if (touch.isBothWays && touch.firstBreed == touch.first.breedNumber && touch.secondBreed == touch.second.breedNumber)
            {
                touch.seenIn = frame;
                pairs.touches[pair] = index;
            }
        }

        // Ends a touch that was not renewed in this frame.
        private function endUnlessSeen(touch:Touch):void
        {
            if (touch.first != null && touch.seenIn != frame)
            {
                _indices.remove(Math.min(touch.first.idNumber, touch.second.idNumber), Math.max(touch.first.idNumber, touch.second.idNumber));
                _ended.add(touch.index, touch.serial);
            }
        }

        // The index of the touch of two agents, in either order; -1 if there is none.
        private function indexOf(a:Agent, b:Agent):int
        {
            return a.idNumber < b.idNumber ? _indices.find(a.idNumber, b.idNumber) : _indices.find(b.idNumber, a.idNumber);
        }
    }
}
