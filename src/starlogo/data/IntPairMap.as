// The room data has what all other rooms share and what knows no geometry: this table; IntList, SortableIntList, IntSet and ListedIntSet, whose memory
// is used again; Fingerprint, which tells data apart; and functions that check lists and arguments, and write errors and warnings.
package starlogo.data
{
    /**
     * A hash table that has a number for each pair of numbers, the keys. It uses open addressing: if the own slot of the keys is taken, they are stored in the
     * next free slot. The table is at most half full. It grows, and never shrinks.
     *
     * @private
     */
    public final class IntPairMap
    {
        private static const MIN_CAPACITY:int = 4;

        // By slot: the two keys, and the value plus 1, which is 0 if the slot is free.
        private var _firsts:Vector.<int> = new Vector.<int>(MIN_CAPACITY);
        private var _seconds:Vector.<int> = new Vector.<int>(MIN_CAPACITY);
        private var _values:Vector.<int> = new Vector.<int>(MIN_CAPACITY);
        private var _count:int = 0;

        /** The value of two keys, or -1 if they have none. Their order matters. Pass 0 as the second key if one is enough. */
        public function find(first:int, second:int):int
        {
            // slotOf() as a loop here, because one more call for each pair takes a tenth of a frame in Adobe's VM
            var firsts:Vector.<int> = _firsts;
            var values:Vector.<int> = _values;
            var mask:int = firsts.length - 1;
            var mixed:int = first * 8191 + second * 131;
            var slot:int = (mixed ^ mixed >>> 11) & mask;
            while (values[slot] != 0)
            {
                if (firsts[slot] == first && _seconds[slot] == second)
                {
                    return values[slot] - 1;
                }
                slot = (slot + 1) & mask;
            }
            return -1;
        }

        /**
         * Sets the value of two keys, which is 0 or more.
         *
         * @return the value that they had, or -1
         */
        public function set (first:int, second:int, value:int):int
        {
            if (2 * _count >= _values.length)
            {
                grow();
            }
            var slot:int = slotOf(first, second);
            var before:int = _values[slot] - 1;
            if (before < 0)
            {
                _firsts[slot] = first;
                _seconds[slot] = second;
                _count++;
            }
            _values[slot] = value + 1;
            return before;
        }

        /** Removes two keys, if they have a value. */
        public function remove(first:int, second:int):void
        {
            var mask:int = _values.length - 1;
            var gap:int = slotOf(first, second);
            if (_values[gap] == 0)
            {
                return;
            }
            _count--;
            // The keys behind the gap move up into it, except keys whose own slot is behind the gap.
            for (var slot:int = (gap + 1) & mask; _values[slot] != 0; slot = (slot + 1) & mask)
            {
                var away:int = slot - hashOf(_firsts[slot], _seconds[slot]) & mask;
                if (away >= ((slot - gap) & mask))
                {
                    _firsts[gap] = _firsts[slot];
                    _seconds[gap] = _seconds[slot];
                    _values[gap] = _values[slot];
                    gap = slot;
                }
            }
            _values[gap] = 0;
        }

        /** Removes all keys. The time grows with the largest number of keys that the table has ever held. */
        public function clear():void
        {
            var values:Vector.<int> = _values;
            var length:int = _count > 0 ? values.length : 0;
            for (var i:int = 0; i < length; i++)
            {
                values[i] = 0;
            }
            _count = 0;
        }

        // Keys that follow one another get different slots, as long as the table is large enough. find() repeats this formula: change both.
        private static function hashOf(first:int, second:int):int
        {
            var mixed:int = first * 8191 + second * 131;
            return mixed ^ mixed >>> 11;
        }

        // The slot of two keys, or the free slot where they belong.
        private function slotOf(first:int, second:int):int
        {
            var firsts:Vector.<int> = _firsts;
            var values:Vector.<int> = _values;
            var mask:int = values.length - 1;
            var slot:int = hashOf(first, second) & mask;
            while (values[slot] != 0 && (firsts[slot] != first || _seconds[slot] != second))
            {
                slot = (slot + 1) & mask;
            }
            return slot;
        }

        private function grow():void
        {
            var firsts:Vector.<int> = _firsts;
            var seconds:Vector.<int> = _seconds;
            var values:Vector.<int> = _values;
            var length:int = 2 * values.length;
            _firsts = new Vector.<int>(length);
            _seconds = new Vector.<int>(length);
            _values = new Vector.<int>(length);
            _count = 0;
            for (var i:int = 0; i < values.length; i++)
            {
                if (values[i] != 0)
                {
                    set (firsts[i], seconds[i], values[i] - 1);
                }
            }
        }
    }
}
