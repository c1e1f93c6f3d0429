package starlogo.handlers
{
    import starlogo.agents.Agent;
    import starlogo.engine;
    import starlogo.geometry.HashTable;
    import starlogo.search.FoundPairs;
    import starlogo.search.KeySort;
    import starlogo.search.NumberList;

    use namespace engine;

    /**
     * Keeps the touches of a Collision from frame to frame: the touch of each pair. If the pairs of a frame are those of the last frame with few
     * changes, only the touches of dropped and added pairs are compared. Objects of ended touches are used again, so a frame allocates nothing
     * unless more agents touch than before. The memory is in proportion to the largest number of pairs that there were.
     *
     * @private
     */
    public final class TouchTracker
    {
        /** The number of the frame, from 1 on. */
        public var frame:int = 0;

        /** The number of touches. */
        public var count:int = 0;

        /** By pair: its touch, or null. The list may be longer. */
        public var touches:Vector.<Touch> = new Vector.<Touch>();

        /** The touches that ended in this frame, in the order in which they began. */
        public var ended:Vector.<Touch> = new Vector.<Touch>();

        /** The number of entries of <code>ended</code> that count. The others are left over from earlier frames. */
        public var endedCount:int = 0;

        // The number of pairs.
        private var _pairCount:int = 0;

        // The revision of the pairs if all their touches are complete, or else 0.
        private var _pairsRevision:int = 0;

        // The touches that end unless they are renewed. Some entries may be null.
        private var _open:Vector.<Touch> = new Vector.<Touch>();
        private var _openCount:int = 0;

        // By index: all touches that there are, and objects for later ones.
        private var _all:Vector.<Touch> = new Vector.<Touch>();

        // By the numbers of two agents, the lesser first: the index of their touch.
        private var _indices:HashTable = new HashTable();

        // The indices of the objects for later touches.
        private var _free:NumberList = new NumberList();

        // The number of touches that ever began.
        private var _begun:Number = 0;

        private var _sort:KeySort = new KeySort();
        private var _order:Vector.<int> = new Vector.<int>();
        private var _keys:Vector.<Number> = new Vector.<Number>();

        /** Whether the touches of all pairs but the added ones go on. Otherwise no pair has a touch when the frame begins. */
        public function areKept(pairs:FoundPairs):Boolean
        {
            return pairs.basis == _pairsRevision;
        }

        /** Begins a frame. The touches of dropped pairs, or of all, end unless they are renewed. */
        public function begin(pairs:FoundPairs):void
        {
            var hasKept:Boolean = areKept(pairs);
            frame++;
            _pairsRevision = 0;
            if (hasKept)
            {
                drop(pairs);
                makeRoom(pairs);
            }
            else
            {
                var spare:Vector.<Touch> = _open;
                _open = touches;
                _openCount = _pairCount;
                touches = spare;
                for (var i:int = 0; i < pairs.count; i++)
                {
                    spare[i] = null;
                }
            }
            _pairCount = pairs.count;
        }

        /**
         * Continues the touch of two agents, if there is one. It does not go on if the breeds have changed, or if handlers were called for the first
         * agent only.
         */
        public function renew(pair:int, a:Agent, b:Agent):void
        {
            var index:int = indexOf(a, b);
            if (index < 0)
            {
                return;
            }
            var touch:Touch = _all[index];
            if (touch.isBothWays && touch.firstBreed == touch.first.breedNumber && touch.secondBreed == touch.second.breedNumber)
            {
                touch.seenIn = frame;
                touches[pair] = touch;
            }
        }

        /** Ends the touches that were not renewed. */
        public function collectEnded():void
        {
            endedCount = 0;
            for (var i:int = 0; i < _openCount; i++)
            {
                var touch:Touch = _open[i];
                if (touch != null && touch.seenIn != frame)
                {
                    // a pair that is listed twice has one touch
                    touch.seenIn = frame;
                    _indices.remove(Math.min(touch.first.idNumber, touch.second.idNumber), Math.max(touch.first.idNumber, touch.second.idNumber));
                    count--;
                    _open[endedCount] = touch;
                    endedCount++;
                }
            }
            sort(_open, endedCount, ended);
        }

        /** Forgets the ended touches. */
        public function forgetEnded():void
        {
            for (var i:int = 0; i < endedCount; i++)
            {
                ended[i].first = ended[i].second = null;
                _free.add(ended[i].index);
            }
            endedCount = 0;
        }

        /**
         * Finds the touch of two agents, and makes it the touch of a pair. If there is none, one begins, of these breeds. If there were fewer pairs,
         * the pair is now the last one.
         */
        public function touchOrStart(pair:int, first:Agent, second:Agent, firstBreed:int, secondBreed:int, isBothWays:Boolean = false):Touch
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
                count++;
            }
            touches[pair] = touch;
            if (pair >= _pairCount)
            {
                _pairCount = pair + 1;
            }
            return touch;
        }

        /** Ends a frame in which each pair with handlers for starts or ends has got its touch, both ways. */
        public function complete(pairs:FoundPairs):void
        {
            _pairsRevision = pairs.revision;
        }

        /** Returns all touches, in the order in which they began. */
        public function inOrder():Vector.<Touch>
        {
            var found:Vector.<Touch> = new Vector.<Touch>();
            for (var i:int = 0; i < _all.length; i++)
            {
                if (_all[i].first != null)
                {
                    found.push(_all[i]);
                }
            }
            var ordered:Vector.<Touch> = new Vector.<Touch>();
            sort(found, found.length, ordered);
            return ordered;
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
            touch.order = _begun;
            _begun++;
            return touch;
        }

        // Opens the touches of dropped pairs. The touches after them move up.
        private function drop(pairs:FoundPairs):void
        {
            var all:Vector.<Touch> = touches;
            var dropped:Vector.<int> = pairs.dropped.numbers;
            _openCount = pairs.dropped.count;
            for (var i:int = 0; i < _openCount; i++)
            {
                var from:int = dropped[i];
                var next:int = i + 1 < _openCount ? dropped[i + 1] : _pairCount;
                _open[i] = all[from];
                for (from++; from < next; from++)
                {
                    all[int(from - i - 1)] = all[from];
                }
            }
        }

        // Moves touches down, so that the added pairs have none.
        private function makeRoom(pairs:FoundPairs):void
        {
            var all:Vector.<Touch> = touches;
            var added:Vector.<int> = pairs.added.numbers;
            var to:int = pairs.count;
            if (all.length < to)
            {
                // grows by an eighth, because a vector that grows a little in each frame is copied each time
                all.length = to + (to >> 3);
            }
            for (var i:int = pairs.added.count - 1; i >= 0; i--)
            {
                for (to--; to > added[i]; to--)
                {
                    all[to] = all[int(to - i - 1)];
                }
                all[to] = null;
            }
        }

        // Writes touches in the order in which they began.
        private function sort(from:Vector.<Touch>, length:int, out:Vector.<Touch>):void
        {
            for (var i:int = 0; i < length; i++)
            {
                _order[i] = i;
                _keys[i] = from[i].order;
            }
            _sort.sort(_order, _keys, length);
            for (i = 0; i < length; i++)
            {
                out[i] = from[_order[i]];
            }
        }

        // The index of the touch of two agents, in either order; -1 if there is none.
        private function indexOf(a:Agent, b:Agent):int
        {
            return a.idNumber < b.idNumber ? _indices.valueOf(a.idNumber, b.idNumber) : _indices.valueOf(b.idNumber, a.idNumber);
        }
    }
}
