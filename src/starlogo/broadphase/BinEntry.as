package starlogo.broadphase
{
    /** An entry of a proxy in a bin: a link of the bin's list. */
    internal final class BinEntry
    {
        /** Whose entry it is. */
        public var proxy:AgentProxy = null;

        /**
         * Where the proxy's rectangle begins: bit 0 is set if in an earlier column than the bin's, bit 1 if in an earlier
         * row.
         */
        public var beginsEarlier:int;

        /** The next entry of the bin's list, or null. */
        public var next:BinEntry = null;

        /** An entry of nothing yet. */
        public function BinEntry()
        {
        }
    }
}
