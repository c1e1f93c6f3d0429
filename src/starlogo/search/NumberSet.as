package starlogo.search
{
    /** A set of whole numbers from 0 on: a hash table with open addressing, at most half full. */
    internal final class NumberSet
    {
        /** Marks a free slot. */
        public static const FREE:int = -1;

        private static const LEAST_SLOTS:int = 4;

        /**
         * The numbers. A number is in the slot of its hash, <code>number ^ number >> 10</code> modulo the number of slots, or in the next free slot
         * after it. The number of slots is a power of two.
         */
        public var slots:Vector.<int> = make(LEAST_SLOTS);

        private var _count:int = 0;

        /** Whether a number is in the set. */
        public function has(number:int):Boolean
        {
            return slots[slotOf(number)] == number;
        }

        /** Adds a number that is not in the set. */
        public function add(number:int):void
        {
            slots[slotOf(number)] = number;
            _count++;
            if (2 * _count > slots.length)
            {
                var old:Vector.<int> = slots;
                slots = make(2 * old.length);
                for (var i:int = 0; i < old.length; i++)
                {
                    if (old[i] != FREE)
                    {
                        slots[slotOf(old[i])] = old[i];
                    }
                }
            }
        }

        private function slotOf(number:int):int
        {
            var last:int = slots.length - 1;
            var slot:int = (number ^ number >> 10) & last;
            while (slots[slot] != number && slots[slot] != FREE)
            {
                slot = slot + 1 & last;
            }
            return slot;
        }

        private static function make(length:int):Vector.<int>
        {
            var made:Vector.<int> = new Vector.<int>(length, true);
            for (var i:int = 0; i < length; i++)
            {
                made[i] = FREE;
            }
            return made;
        }
    }
}
