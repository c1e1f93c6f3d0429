package starlogo.geometry.vertices
{
    import flash.utils.ByteArray;

    /**
     * A hash table of points, which keeps each position once. If very many points have neighbouring slots, some may be kept several times,
     * because that takes less time than a full search.
     *
     * @private
     */
    public final class PointTable
    {
        private static const MAX_PROBES:int = 64;

        /** The coordinates x, y, z, ... of the points, in the order in which they were first added. */
        public var coordinates:Vector.<Number> = new Vector.<Number>();

        // For each slot: its point's index plus 1, or 0 if the slot is empty.
        private var _slots:Vector.<int>;
        private var _bits:ByteArray = new ByteArray();

        /**
         * Creates a table without points. It reserves all memory at once, because growing later would take long in one call.
         *
         * @param most the largest number of points
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

        /** Adds the point at a place, if it is not there yet. Returns its index. */
        public function add(x:Number, y:Number, z:Number):int
        {
            var mask:int = _slots.length - 1;
            var slot:int = hash(x, y, z) & mask;
            var probes:int = 0;
            while (_slots[slot] != 0 && probes < MAX_PROBES)
            {
                if (isAt(_slots[slot] - 1, x, y, z))
                {
                    return _slots[slot] - 1;
                }
                slot = (slot + 1) & mask;
                probes++;
            }
            var index:int = coordinates.length / 3;
            coordinates.push(x, y, z);
            if (probes < MAX_PROBES)
            {
                _slots[slot] = index + 1;
            }
            return index;
        }

        private function isAt(point:int, x:Number, y:Number, z:Number):Boolean
        {
            return coordinates[3 * point] == x && coordinates[3 * point + 1] == y && coordinates[3 * point + 2] == z;
        }

        private function hash(x:Number, y:Number, z:Number):int
        {
            _bits.position = 0;
            // 0 and -0 are one place.
            _bits.writeDouble(x + 0);
            _bits.writeDouble(y + 0);
            _bits.writeDouble(z + 0);
            _bits.position = 0;
            var hash:int = 0;
            for (var i:int = 0; i < 6; i++)
            {
                // The product is below 2 to the 53rd, so all of its lowest bits are exact.
                hash = (hash ^ hash >>> 15 ^ _bits.readInt()) * 69069;
            }
            return hash ^ hash >>> 15;
        }
    }
}
