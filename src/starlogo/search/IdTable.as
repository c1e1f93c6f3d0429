package starlogo.search
{
    /**
     * A number for each of many agents, by their ids. Open addressing: what is not at its own place is at the first free one behind it.
     * It grows, and does not shrink.
     *
     * @private
     */
    public final class IdTable
    {
        private static const FEWEST:int = 16;

        // 0 is a free place: no id is 0.
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
            var place:int = placeOf(id);
            return _ids[place] == 0 ? -1 : _values[place];
        }

        /**
         * Gives an id a value, in place of the one that it has.
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
            var place:int = placeOf(id);
            if (_ids[place] == 0)
            {
                _ids[place] = id;
                _count++;
            }
            _values[place] = value;
        }

        /** Takes an id out, if it is there. */
        public function remove(id:int):void
        {
            var ids:Vector.<int> = _ids;
            var mask:int = ids.length - 1;
            var gap:int = placeOf(id);
            if (ids[gap] == 0)
            {
                return;
            }
            _count--;
            // those after it move up, except for those that would come before their own place
            for (var place:int = (gap + 1) & mask; ids[place] != 0; place = (place + 1) & mask)
            {
                var other:int = ids[place];
                var away:int = (place - (other ^ other >> 5 ^ other >> 11 ^ other >> 17)) & mask;
                if (away >= ((place - gap) & mask))
                {
                    ids[gap] = other;
                    _values[gap] = _values[place];
                    gap = place;
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

        // Where an id is, or the free place where it belongs. Ids that follow one another have places of their own.
        private function placeOf(id:int):int
        {
            var ids:Vector.<int> = _ids;
            var mask:int = ids.length - 1;
            var place:int = (id ^ id >> 5 ^ id >> 11 ^ id >> 17) & mask;
            var there:int = ids[place];
            while (there != id)
            {
                if (there == 0)
                {
                    return place;
                }
                place = (place + 1) & mask;
                there = ids[place];
            }
            return place;
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
