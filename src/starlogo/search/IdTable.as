package starlogo.search
{
    /**
     * A number for each of many agents, by their ids. Open addressing: an id that is not in its own slot is in the first free one behind it.
     * It grows, and does not shrink.
     *
     * @private
     */
    public final class IdTable
    {
        private static const FEWEST:int = 16;

        // 0 is a free slot: no id is 0.
        private var _ids:Vector.<int> = new Vector.<int>(FEWEST);
        private var _values:Vector.<int> = new Vector.<int>(FEWEST);
        private var _count:int = 0;

        /** An empty table. */
        public function IdTable()
        {
        }

        /**
         * The value of an id; -1 if it has none.
         *
         * @param id positive
         */
        public function valueOf(id:int):int
        {
            var slot:int = slotOf(id);
            return _ids[slot] == 0 ? -1 : _values[slot];
        }

        /**
         * Gives an id a value, instead of the one that it has.
         *
         * @param id positive
         * @param value any but -1
         */
        public function set (id:int, value:int):void
        {
            if (2 * _count >= _ids.length)
            {
                grow();
            }
            var slot:int = slotOf(id);
            if (_ids[slot] == 0)
            {
                _ids[slot] = id;
                _count++;
            }
            _values[slot] = value;
        }

        /** Takes an id out, if it is there. */
        public function remove(id:int):void
        {
            var ids:Vector.<int> = _ids;
            var mask:int = ids.length - 1;
            var gap:int = slotOf(id);
            if (ids[gap] == 0)
            {
                return;
            }
            _count--;
            // those after it move up, except for those that would come before their own slot
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

        /** Takes all out; in time in proportion to the most that the table has ever held. */
        public function clear():void
        {
            var ids:Vector.<int> = _ids;
            var length:int = _count > 0 ? ids.length : 0;
            for (var i:int = 0; i < length; i++)
            {
                ids[i] = 0;
            }
            _count = 0;
        }

        // Where an id is, or the free slot where it belongs. Ids that follow one another have slots of their own.
        private function slotOf(id:int):int
        {
            var ids:Vector.<int> = _ids;
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
            var ids:Vector.<int> = _ids;
            var values:Vector.<int> = _values;
            _ids = new Vector.<int>(2 * ids.length);
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
