package starlogo.search
{
    import starlogo.agents.Agent;
    import starlogo.engine;
    import starlogo.geometry.Placement;

    use namespace engine;

    /**
     * Knows the places of a table's agents in the last two searches, and which rows have changed between the two. An agent that has not changed
     * costs a comparison.
     *
     * @private
     */
    public class PlacedRows extends RowList
    {
        // In place of a revision: the value has to be computed again.
        protected static const STALE:int = -1;

        // The places in the last search, and in the one before. Agents that have changed are read into the older ones, and the two are exchanged
        // after the whole list has turned out to be valid. A row that has not changed has the same place in both.
        engine var now:RowPlaces = new RowPlaces();
        internal var last:RowPlaces = new RowPlaces();

        /** By row: the agent's <code>extentsRevision</code> at which its extents were computed, or STALE. */
        protected var extentsRevisions:Vector.<int> = new Vector.<int>();

        /** By row: the number of the agent's breed. The breeds of the ground and of the edges have the numbers of their rows. */
        internal var breeds:Vector.<int> = new <int>[GROUND, EDGES];

        /** The rows that the last search has read again, because their agents had changed since the search before. */
        internal var moved:NumberList = new NumberList();

        /** The rows that the search before has read again. */
        internal var movedBefore:NumberList = new NumberList();

        // The rows that are being read. They become moved after the whole list has turned out to be valid.
        private var _reading:NumberList = new NumberList();

        /** The rows whose extents have to be computed again. */
        protected var changed:NumberList = new NumberList();

        /** Lets no agent have a motion from its position in the last search. */
        public function forgetMotions():void
        {
            for (var row:int = 0; row < now.revisions.length; row++)
            {
                now.revisions[row] = RowPlaces.NOT_SEEN;
            }
        }

        /**
         * Reads the places of agents that have changed since the last search, and lists the rows of those with changes in more than the place.
         *
         * @return false if the rows do not belong to the agents
         */
        protected function readChanged(list:Vector.<Agent>, rowsOfList:Vector.<int>):Boolean
        {
            var byRow:Vector.<Agent> = agents;
            var seen:Vector.<int> = now.revisions;
            var extentsSeen:Vector.<int> = extentsRevisions;
            var read:Vector.<int> = last.revisions;
            var readX:Vector.<Number> = last.x;
            var readY:Vector.<Number> = last.y;
            var readZ:Vector.<Number> = last.z;
            var reading:Vector.<int> = _reading.numbers;
            var end:int = list.length;
            var found:int = 0;
            changed.count = 0;
            for (var i:int = 0; i < end; i++)
            {
                var row:int = rowsOfList[i];
                var agent:Agent = list[i];
                if (byRow[row] !== agent)
                {
                    return false;
                }
                var revision:int = agent.revision;
                if (revision != seen[row] || extentsSeen[row] == STALE)
                {
                    var placement:Placement = agent.placement;
                    if (placement.extentsRevision != extentsSeen[row])
                    {
                        changed.add(row);
                    }
                    reading[found] = row;
                    found++;
                    read[row] = revision;
                    readX[row] = placement.x;
                    readY[row] = placement.y;
                    readZ[row] = placement.z;
                    breeds[row] = agent.breedNumber;
                }
            }
            _reading.count = found;
            return true;
        }

        /** Makes the places that were read the present ones. Rows that have not changed get their present place in both. */
        protected function exchangePlaces():void
        {
            var older:RowPlaces = last;
            last = now;
            now = older;
            var spare:NumberList = movedBefore;
            movedBefore = moved;
            moved = _reading;
            _reading = spare;
            if (moved.count < count)
            {
                settle();
            }
        }

        private function settle():void
        {
            for (var i:int = 0; i < movedBefore.count; i++)
            {
                var row:int = movedBefore.numbers[i];
                if (now.revisions[row] < last.revisions[row])
                {
                    now.copyRow(last, row);
                }
            }
        }

        /** @inheritDoc */
        override protected function grow(length:int):void
        {
            super.grow(length);
            var row:int = extentsRevisions.length;
            extentsRevisions.length = breeds.length = length;
            now.grow(length);
            last.grow(length);
            for (; row < length; row++)
            {
                extentsRevisions[row] = STALE;
            }
        }

        /** @inheritDoc */
        override protected function free(row:int):void
        {
            super.free(row);
            extentsRevisions[row] = STALE;
        }
    }
}
