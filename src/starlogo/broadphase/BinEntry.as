package starlogo.broadphase
{
    /** An entry of a proxy in a bin: a link of the bin's list. */
    internal final class BinEntry
    {
        /** Whose entry it is. */
        public var proxy:AgentProxy;

        /**
         * Where the proxy's rectangle begins: bit 0 is set if in an earlier column than the bin's, bit 1 if in an earlier
         * row. A proxy has one entry of each kind.
         */
        public var beginsEarlier:int;

        /** The next entry of the bin's list, or null. */
        public var next:BinEntry = null;

        /** The proxy's next entry, in a ring. */
        public var sibling:BinEntry;

        /**
         * @param proxy whose entry it is
         * @param beginsEarlier which of the proxy's entries it is, from 0 to 3
         */
        public function BinEntry(proxy:AgentProxy, beginsEarlier:int)
        {
            this.proxy = proxy;
            this.beginsEarlier = beginsEarlier;
        }

        /** All the entries that a proxy will need, in order. */
        public static function ring(proxy:AgentProxy):BinEntry
        {
            var first:BinEntry = new BinEntry(proxy, 0);
            var last:BinEntry = first;
            for (var i:int = 1; i < 4; i++)
            {
                last.sibling = new BinEntry(proxy, i);
                last = last.sibling;
            }
            last.sibling = first;
            return first;
        }
    }
}
