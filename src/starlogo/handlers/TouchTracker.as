package starlogo.handlers
{
    import starlogo.agents.Agent;
    import starlogo.engine;

    use namespace engine;

    /**
     * Keeps the touching pairs from frame to frame, in the order in which their touches began. A table finds a touch by the agents' ids, as in
     * IdTable. Objects of ended touches are used again, so a frame allocates nothing unless more agents touch than before. The memory is in
     * proportion to the number of touching pairs.
     *
     * @private
     */
    public final class TouchTracker
    {
        private static const LEAST_LENGTH:int = 16;

        /** The number of the frame, which the caller advances. */
        public var frame:int = 0;

        /** The number of touching pairs. */
        public var count:int = 0;

        /** The touches that ended in this frame, in the order in which they began. */
        public var ended:Vector.<Touch> = new Vector.<Touch>();

        /** The number of entries of <code>ended</code> that count. The others are left over from earlier frames. */
        public var endedCount:int = 0;

        // The touches, followed by objects for later touches.
        private var _pairs:Vector.<Touch> = new Vector.<Touch>();
        private var _table:Vector.<Touch> = new Vector.<Touch>(LEAST_LENGTH);

        /**
         * Continues the touch of two agents.
         *
         * @return the touch, or null. If the breeds have changed, or if handlers were called for the first agent only, the touch counts as ended
         */
        public function renew(a:Agent, b:Agent):Touch
        {
            var pair:Touch = _table[slotOf(a, b)];
            if (pair == null || !pair.isBothWays || pair.firstBreed != pair.first.breedNumber || pair.secondBreed != pair.second.breedNumber)
            {
                return null;
            }
            pair.seenIn = frame;
            return pair;
        }

        /** Returns the touch of two agents of these breeds. If there is none, it begins. */
        public function start(first:Agent, second:Agent, firstBreed:int, secondBreed:int, isBothWays:Boolean = false):Touch
        {
            var slot:int = slotOf(first, second);
            if (_table[slot] != null)
            {
                return _table[slot];
            }
            if (count == _pairs.length)
            {
                _pairs[count] = new Touch();
            }
            var pair:Touch = _pairs[count];
            pair.first = first;
            pair.second = second;
            pair.firstBreed = firstBreed;
            pair.secondBreed = secondBreed;
            pair.beganIn = pair.seenIn = frame;
            pair.isBothWays = isBothWays;
            _table[slot] = pair;
            count++;
            if (2 * count > _table.length)
            {
                fill(2 * _table.length);
            }
            return pair;
        }

        /** Returns one of <code>count</code> touches, in the order in which they began. */
        public function pairAt(index:int):Touch
        {
            return _pairs[index];
        }

        /** Forgets all pairs. None of them counts as ended. */
        public function clear():void
        {
            for (var i:int = 0; i < count; i++)
            {
                _pairs[i].first = _pairs[i].second = null;
            }
            count = 0;
            fill(_table.length);
        }

        /** Moves the pairs that do not touch in this frame into <code>ended</code>. */
        public function collectEnded():void
        {
            var kept:int = 0;
            endedCount = 0;
            for (var i:int = 0; i < count; i++)
            {
                var pair:Touch = _pairs[i];
                if (pair.seenIn == frame)
                {
                    _pairs[kept] = pair;
                    kept++;
                }
                else
                {
                    ended[endedCount] = pair;
                    endedCount++;
                }
            }
            count = kept;
            // their objects are kept for later touches
            for (i = 0; i < endedCount; i++)
            {
                _pairs[count + i] = ended[i];
            }
            if (endedCount > 0)
            {
                fill(_table.length > LEAST_LENGTH && 16 * count < _table.length ? _table.length >> 2 : _table.length);
            }
        }

        /** Forgets the ended touches. */
        public function forgetEnded():void
        {
            for (var i:int = 0; i < endedCount; i++)
            {
                ended[i].first = ended[i].second = null;
                ended[i] = null;
            }
            endedCount = 0;
            if (_pairs.length > 4 * count + LEAST_LENGTH)
            {
                _pairs.length = 2 * count + LEAST_LENGTH;
            }
        }

        // Makes a table of this length, a power of two, and enters all pairs again.
        private function fill(length:int):void
        {
            if (_table.length != length)
            {
                _table = new Vector.<Touch>(length);
            }
            for (var i:int = 0; i < length; i++)
            {
                _table[i] = null;
            }
            for (i = 0; i < count; i++)
            {
                _table[slotOf(_pairs[i].first, _pairs[i].second)] = _pairs[i];
            }
        }

        // The slot of a pair in the table, in either order of its agents, or the free slot where it belongs.
        private function slotOf(a:Agent, b:Agent):int
        {
            var idA:int = a.id;
            var idB:int = b.id;
            var mixed:int = idA < idB ? idA * 8191 + idB * 131 : idB * 8191 + idA * 131;
            var mask:int = _table.length - 1;
            var slot:int = (mixed ^ mixed >>> 11) & mask;
            var pair:Touch = _table[slot];
            while (pair != null && !(pair.first === a && pair.second === b) && !(pair.first === b && pair.second === a))
            {
                slot = (slot + 1) & mask;
                pair = _table[slot];
            }
            return slot;
        }
    }
}
