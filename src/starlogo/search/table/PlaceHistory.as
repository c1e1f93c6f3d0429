package starlogo.search.table
{
    import starlogo.agents.Agent;
    import starlogo.data.NumberList;

    /**
     * Where the agents of a table were in the last two searches, and which of them have changed. An agent's motion goes from one place to the other.
     *
     * @private
     */
    public final class PlaceHistory
    {
        /** The places in the last search. */
        public var last:RowPlaces = new RowPlaces();

        /**
         * The places in the search before the last. A row that has not changed has the same place in both. Between <code>beginRead()</code> and
         * <code>acceptRead()</code> it receives the new places, so it holds neither search then.
         */
        public var previous:RowPlaces = new RowPlaces();

        /** The rows that the last search has read again, because their agents had changed. */
        public var changed:NumberList = new NumberList();

        /** The rows that the search before has read again. */
        public var previouslyChanged:NumberList = new NumberList();

        // The rows that a new search reads.
        private var _read:NumberList = new NumberList();

        /** Begins to read the places of a new search. The places of the search before last are lost. */
        public function beginRead():void
        {
            _read.count = 0;
        }

        /** Reads the place of an agent that has changed. The last places count until <code>acceptRead()</code>. */
        public function read(row:int, agent:Agent):void
        {
            _read.add(row);
            previous.read(row, agent);
        }

        /**
         * Makes the places that were read the last ones.
         *
         * @param agentCount the number of listed agents
         */
        public function acceptRead(agentCount:int):void
        {
            var older:RowPlaces = previous;
            previous = last;
            last = older;
            var spare:NumberList = previouslyChanged;
            previouslyChanged = changed;
            changed = _read;
            _read = spare;
            if (changed.count < agentCount)
            {
                copyStill();
            }
        }

        // Gives rows that changed before, and not now, their present place in both searches.
        private function copyStill():void
        {
            for (var i:int = 0; i < previouslyChanged.count; i++)
            {
                var row:int = previouslyChanged.numbers[i];
                if (last.revisions[row] < previous.revisions[row])
                {
                    last.copyRow(previous, row);
                }
            }
        }

        /** Lets no agent have a motion from its place in the last search. */
        public function forgetMotions():void
        {
            for (var row:int = 0; row < last.revisions.length; row++)
            {
                last.revisions[row] = RowPlaces.NOT_SEEN;
            }
        }

        /** Makes sure that there are this many rows. */
        public function grow(length:int):void
        {
            last.grow(length);
            previous.grow(length);
        }
    }
}
