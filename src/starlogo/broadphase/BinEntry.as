package starlogo.broadphase
{
    /** An entry of a proxy in a bin: a link of the bin's list. */
    internal final class BinEntry
    {
        /** Whose entry it is. */
        public var proxy:AgentProxy;

        /**
         * Where the proxy's rectangle begins: bit 0 is set if in an earlier column than the bin's, bit 1 if in an earlier
         * row.
         */
        public var beginsEarlier:int;

        /** The next entry of the bin's list, or null. */
        public var next:BinEntry = null;

        /** The proxy's next entry, in a ring. */
        public var sibling:BinEntry;

        /**
         * @param proxy whose entry it is
         */
        public function BinEntry(proxy:AgentProxy)
        {
            this.proxy = proxy;
        }

        /** All the entries that a proxy will need. */
        public static function ring(proxy:AgentProxy, count:int):BinEntry
        {
            var first:BinEntry = new BinEntry(proxy);
            var last:BinEntry = first;
            for (var i:int = 1; i < count; i++)
            {
                last.sibling = new BinEntry(proxy);
                last = last.sibling;
            }
            last.sibling = first;
            return first;
        }
    }
}
