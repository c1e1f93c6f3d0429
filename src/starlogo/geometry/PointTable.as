package starlogo.geometry
{
    import flash.utils.ByteArray;

    /**
     * Points, each position once: a hash table of their coordinates. Of points that are made to meet in the table some may be there several
     * times, which takes less time than to find out.
     *
     * @private
     */
    public final class PointTable
    {
        private static const MOST_LOOKS:int = 64;

        /** x, y, z, ... in the order in which the points were first added. */
        public var coordinates:Vector.<Number> = new Vector.<Number>();

        // one more than the number of the point in each slot, 0 where there is none
        private var _slots:Vector.<int>;
        private var _count:int = 0;
        private var _bits:ByteArray = new ByteArray();

        /**
         * A table without points, with all the room that it will need: making room later would take long at once.
         *
         * @param most how many points there may be at most
         */
        public function PointTable(most:int)
        {
            var size:int = 2;
            while (size < 2 * most)
            {
                size *= 2;
            }
            _slots = new Vector.<int>(size, true);
        }

        /** The number of the point at a place; it is added if there is none. */
        public function indexOf(x:Number, y:Number, z:Number):int
        {
            var mask:int = _slots.length - 1;
            var slot:int = hash(x, y, z) & mask;
            var looks:int = 0;
            while (_slots[slot] != 0 && looks < MOST_LOOKS)
            {
                if (isAt(_slots[slot] - 1, x, y, z))
                {
                    return _slots[slot] - 1;
                }
                slot = (slot + 1) & mask;
                looks++;
            }
            coordinates.push(x, y, z);
            if (looks < MOST_LOOKS)
            {
                _slots[slot] = _count + 1;
            }
            return _count++;
        }

        private function isAt(point:int, x:Number, y:Number, z:Number):Boolean
        {
            return coordinates[3 * point] == x && coordinates[3 * point + 1] == y && coordinates[3 * point + 2] == z;
        }

        private function hash(x:Number, y:Number, z:Number):int
        {
            _bits.position = 0;
            // 0 and -0 are one place
            _bits.writeDouble(x + 0);
            _bits.writeDouble(y + 0);
            _bits.writeDouble(z + 0);
            _bits.position = 0;
            var hash:int = 0;
            for (var i:int = 0; i < 6; i++)
            {
                // a product below 2 to the 53rd: all of its lowest bits count
                hash = (hash ^ hash >>> 15 ^ _bits.readInt()) * 69069;
            }
            return hash ^ hash >>> 15;
        }
    }
}
