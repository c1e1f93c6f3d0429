package starlogo.handlers
{
    import starlogo.agents.Agent;
    import starlogo.engine;
    import starlogo.search.FoundPairs;
    import starlogo.search.KeySort;

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
        private static const LEAST_LENGTH:int = 16;

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

        // The number of pairs; and their revision if all their touches are complete, or else 0.
        private var _pairCount:int = 0;
        private var _pairsRevision:int = 0;

        // The touches that end unless they are renewed. Some entries may be null.
        private var _open:Vector.<Touch> = new Vector.<Touch>();
        private var _openCount:int = 0;

        // A hash table of all touches, with open addressing. It is at most half full, and its length is a power of two. The last hash that was
        // computed.
        private var _table:Vector.<Touch> = new Vector.<Touch>(LEAST_LENGTH);
        private var _hash:int;

        // Objects for later touches, and the number of touches that ever began.
        private var _spares:Vector.<Touch> = new Vector.<Touch>();
        private var _spareCount:int = 0;
        private var _begun:Number = 0;

        private var _sort:KeySort = new KeySort();
        private var _indices:Vector.<int> = new Vector.<int>();
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
            var touch:Touch = _table[slotOf(a, b)];
            if (touch != null && touch.isBothWays && touch.firstBreed == touch.first.breedNumber && touch.secondBreed == touch.second.breedNumber)
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
                    remove(touch);
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
                _spares[_spareCount] = ended[i];
                _spareCount++;
            }
            endedCount = 0;
        }

        /** Returns the touch of a pair, of two agents with these breeds. If there is none, it begins. */
        public function start(pair:int, first:Agent, second:Agent, firstBreed:int, secondBreed:int, isBothWays:Boolean = false):Touch
        {
            var slot:int = slotOf(first, second);
            var touch:Touch = _table[slot];
            if (touch == null)
            {
                touch = _table[slot] = newTouch();
                touch.first = first;
                touch.second = second;
                touch.firstBreed = firstBreed;
                touch.secondBreed = secondBreed;
                touch.isBothWays = isBothWays;
                touch.hash = _hash;
                count++;
                if (2 * count > _table.length)
                {
                    growTable();
                }
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
            for (var i:int = 0; i < _table.length; i++)
            {
                if (_table[i] != null)
                {
                    found.push(_table[i]);
                }
            }
            var ordered:Vector.<Touch> = new Vector.<Touch>();
            sort(found, found.length, ordered);
            return ordered;
        }

        private function newTouch():Touch
        {
            var touch:Touch;
            if (_spareCount > 0)
            {
                _spareCount--;
                touch = _spares[_spareCount];
            }
            else
            {
                touch = new Touch();
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
                _indices[i] = i;
                _keys[i] = from[i].order;
            }
            _sort.sort(_indices, _keys, length);
            for (i = 0; i < length; i++)
            {
                out[i] = from[_indices[i]];
            }
        }

        private function growTable():void
        {
            var before:Vector.<Touch> = _table;
            _table = new Vector.<Touch>(2 * before.length);
            for (var i:int = 0; i < before.length; i++)
            {
                if (before[i] != null)
                {
                    _table[slotOf(before[i].first, before[i].second)] = before[i];
                }
            }
        }

        // The touches behind the gap move up into it, except a touch whose own slot is behind the gap.
        private function remove(touch:Touch):void
        {
            var mask:int = _table.length - 1;
            var gap:int = slotOf(touch.first, touch.second);
            for (var slot:int = (gap + 1) & mask; _table[slot] != null; slot = (slot + 1) & mask)
            {
                var other:Touch = _table[slot];
                if (((slot - other.hash) & mask) >= ((slot - gap) & mask))
                {
                    _table[gap] = other;
                    gap = slot;
                }
            }
            _table[gap] = null;
            count--;
        }

        // The slot of a pair in the table, in either order of its agents, or the free slot where it belongs.
        private function slotOf(a:Agent, b:Agent):int
        {
            var idA:int = a.number;
            var idB:int = b.number;
            var mixed:int = idA < idB ? idA * 8191 + idB * 131 : idB * 8191 + idA * 131;
            var mask:int = _table.length - 1;
            _hash = mixed ^ mixed >>> 11;
            var slot:int = _hash & mask;
            var touch:Touch = _table[slot];
            while (touch != null && !(touch.first === a && touch.second === b) && !(touch.first === b && touch.second === a))
            {
                slot = (slot + 1) & mask;
                touch = _table[slot];
            }
            return slot;
        }
    }
}
