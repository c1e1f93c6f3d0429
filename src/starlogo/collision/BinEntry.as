package starlogo.collision
{
    /** An entry of a body in a bin: a link of the bin's list. */
    internal final class BinEntry
    {
        /** Whose entry it is. */
        public var body:Body;

        /**
         * Where the body's rectangle begins: bit 0 is set if in an earlier column than the bin's, bit 1 if in an earlier
         * row.
         */
        public var beginsEarlier:int;

        /** The next entry of the bin's list, or null. */
        public var next:BinEntry;

        /** The body's next entry, in a ring. */
        public var sibling:BinEntry;

        /**
         * @param body whose entry it is
         */
        public function BinEntry(body:Body)
        {
            this.body = body;
        }

        /** All the entries that a body will need. */
        public static function ring(body:Body, count:int):BinEntry
        {
            var first:BinEntry = new BinEntry(body);
            var last:BinEntry = first;
            for (var i:int = 1; i < count; i++)
            {
                last.sibling = new BinEntry(body);
                last = last.sibling;
            }
            last.sibling = first;
            return first;
        }
    }
}
