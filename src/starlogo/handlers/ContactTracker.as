package starlogo.handlers
{
    import starlogo.agents.Agent;
    import starlogo.engine;

    use namespace engine;

    /**
     * Keeps from frame to frame which agents touch, in the order in which that began; a table finds pairs by the agents' ids, as IdTable
     * does. Pairs that have ended are used again: a frame allocates nothing unless more touch than before, and memory is in proportion
     * to the pairs that touch.
     *
     * @private
     */
    public final class ContactTracker
    {
        private static const LEAST_LENGTH:int = 16;

        /** The number of the frame, which the caller advances. */
        public var frame:int = 0;

        /** How many pairs touch. */
        public var count:int = 0;

        /** The pairs that touched before this frame and do not any more, in the order in which their contacts began. */
        public var ended:Vector.<ContactPair> = new Vector.<ContactPair>();

        /** How many entries of <code>ended</code> count, from its beginning. */
        public var endedCount:int = 0;

        // Those that touch, and after them others to be used again.
        private var _pairs:Vector.<ContactPair> = new Vector.<ContactPair>();
        private var _table:Vector.<ContactPair> = new Vector.<ContactPair>(LEAST_LENGTH);

        /** No agents touch. */
        public function ContactTracker()
        {
        }

        /**
         * Continues the contact of two agents.
         *
         * @return null if there is none. A contact of other breeds, or one that has not begun in both directions, counts as ended
         */
        public function renew(a:Agent, b:Agent):ContactPair
        {
            var pair:ContactPair = _table[placeOf(a, b)];
            if (pair == null || !pair.isBothWays || pair.firstBreed != pair.first.breedNumber || pair.secondBreed != pair.second.breedNumber)
            {
                return null;
            }
            pair.seenIn = frame;
            return pair;
        }

        /** The contact of two agents, which begins if there is none. */
        public function start(first:Agent, second:Agent):ContactPair
        {
            var place:int = placeOf(first, second);
            return _table[place] || add(place, first, second, first.breedNumber, second.breedNumber, false);
        }

        /**
         * Has a contact of two agents that began in an earlier frame.
         *
         * @return false if there is one already
         */
        public function resume(first:Agent, second:Agent, firstBreed:int, secondBreed:int, isBothWays:Boolean):Boolean
        {
            var place:int = placeOf(first, second);
            if (_table[place] != null)
            {
                return false;
            }
            add(place, first, second, firstBreed, secondBreed, isBothWays);
            return true;
        }

        /** A pair that touches, of <code>count</code>, in the order in which the contacts began. */
        public function pairAt(index:int):ContactPair
        {
            return _pairs[index];
        }

        /** Lets go of all pairs, without an end. */
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
        public function separateEnded():void
        {
            var kept:int = 0;
            endedCount = 0;
            for (var i:int = 0; i < count; i++)
            {
                var pair:ContactPair = _pairs[i];
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
            for (i = 0; i < endedCount; i++)
            {
                _pairs[kept + i] = ended[i];
            }
            if (endedCount > 0)
            {
                fill(_table.length > LEAST_LENGTH && 16 * count < _table.length ? _table.length >> 2 : _table.length);
            }
        }

        /** Lets go of those that have ended. */
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

        private function add(place:int, first:Agent, second:Agent, firstBreed:int, secondBreed:int, isBothWays:Boolean):ContactPair
        {
            if (count == _pairs.length)
            {
                _pairs[count] = new ContactPair();
            }
            var pair:ContactPair = _pairs[count];
            pair.first = first;
            pair.second = second;
            pair.firstBreed = firstBreed;
            pair.secondBreed = secondBreed;
            pair.beganIn = pair.seenIn = frame;
            pair.isBothWays = isBothWays;
            _table[place] = pair;
            count++;
            if (2 * count > _table.length)
            {
                fill(2 * _table.length);
            }
            return pair;
        }

        // Makes the table of this length, a power of two, and enters all pairs anew.
        private function fill(length:int):void
        {
            if (_table.length != length)
            {
                _table = new Vector.<ContactPair>(length);
            }
            for (var i:int = 0; i < length; i++)
            {
                _table[i] = null;
            }
            for (i = 0; i < count; i++)
            {
                _table[placeOf(_pairs[i].first, _pairs[i].second)] = _pairs[i];
            }
        }

        // Where a pair is in the table, in either order, or the free place where it belongs.
        private function placeOf(a:Agent, b:Agent):int
        {
            var idA:int = a.id;
            var idB:int = b.id;
            var mixed:int = idA < idB ? idA * 8191 + idB * 131 : idB * 8191 + idA * 131;
            var mask:int = _table.length - 1;
            var place:int = (mixed ^ mixed >>> 11) & mask;
            var pair:ContactPair = _table[place];
            while (pair != null && !(pair.first === a && pair.second === b) && !(pair.first === b && pair.second === a))
            {
                place = (place + 1) & mask;
                pair = _table[place];
            }
            return place;
        }
    }
}
