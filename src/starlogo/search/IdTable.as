package starlogo.search
{
    /**
     * A hash table that stores a number for each id, such as an agent's. It uses open addressing: if an id's own slot is taken, the id is
     * stored in the next free slot. The table grows, and never shrinks.
     *
     * @private
     */
    public final class IdTable
    {
        private static const FEWEST:int = 4;

        /** By slot: the id. 0 marks a free slot, because no id is 0. */
        internal var slots:Vector.<int> = new Vector.<int>(FEWEST);
        private var _values:Vector.<int> = new Vector.<int>(FEWEST);
        private var _count:int = 0;

        /** Whether an id has a value. */
        public function has(id:int):Boolean
        {
            return slots[slotOf(id)] == id;
        }

        /**
         * The value of an id, or -1 if it has none.
         *
         * @param id positive
         */
        public function valueOf(id:int):int
        {
            var slot:int = slotOf(id);
            return slots[slot] == 0 ? -1 : _values[slot];
        }

        /**
         * Sets the value of an id, and overwrites the value that it had.
         *
         * @param id positive
         * @param value any number but -1
         */
        public function set (id:int, value:int):void
        {
            if (2 * _count >= slots.length)
            {
                grow();
            }
            var slot:int = slotOf(id);
            if (slots[slot] == 0)
            {
                slots[slot] = id;
                _count++;
            }
            _values[slot] = value;
        }

        /** Removes an id, if it is in the table. */
        public function remove(id:int):void
        {
            var ids:Vector.<int> = slots;
            var mask:int = ids.length - 1;
            var gap:int = slotOf(id);
            if (ids[gap] == 0)
            {
                return;
            }
            _count--;
            // The ids behind the gap move up into it, except an id whose own slot is behind the gap.
            for (var slot:int = (gap + 1) & mask; ids[slot] != 0; slot = (slot + 1) & mask)
            {
                var other:int = ids[slot];
                var away:int = (slot - (other ^ other >> 5 ^ other >> 11 ^ other >> 17)) & mask;
                if (away >= ((slot - gap) & mask))
                {
                    ids[gap] = other;
                    _values[gap] = _values[slot];
                    gap = slot;
                }
            }
            ids[gap] = 0;
        }

        /** Removes all ids. The time grows with the largest number of ids that the table has ever held. */
        public function clear():void
        {
            var ids:Vector.<int> = slots;
            var length:int = _count > 0 ? ids.length : 0;
            for (var i:int = 0; i < length; i++)
            {
                ids[i] = 0;
            }
            _count = 0;
        }

        /**
         * The slot of an id, or the free slot where it belongs. The hash gives consecutive ids different slots, as long as the table is large enough.
         */
        internal function slotOf(id:int):int
        {
            var ids:Vector.<int> = slots;
            var mask:int = ids.length - 1;
            var slot:int = (id ^ id >> 5 ^ id >> 11 ^ id >> 17) & mask;
            var there:int = ids[slot];
            while (there != id)
            {
                if (there == 0)
                {
                    return slot;
                }
                slot = (slot + 1) & mask;
                there = ids[slot];
            }
            return slot;
        }

        private function grow():void
        {
            var ids:Vector.<int> = slots;
            var values:Vector.<int> = _values;
            slots = new Vector.<int>(2 * ids.length);
            _values = new Vector.<int>(2 * ids.length);
            _count = 0;
            for (var i:int = 0; i < ids.length; i++)
            {
                if (ids[i] != 0)
                {
                    set (ids[i], values[i]);
                }
            }
        }
    }
}
