package starlogo.search
{
    import starlogo.data.SortableIntList;
    import starlogo.search.table.ListedAgents;

    /**
     * Puts the pairs of a search into order: by the list indices of their first agents, then of their second ones, and before that by their times if an
     * agent sweeps.
     */
    internal final class PairOrder
    {
        // The indices of the pairs with their times, to sort them by these.
        private var _indices:SortableIntList = new SortableIntList();

        // By list index: where the next pair goes whose row on a side has the index, in a counting sort.
        private var _next:Vector.<int> = new Vector.<int>();

        /**
         * Puts pairs into order.
         *
         * @return how many pairs touch before the end of their motions. They come first
         */
        public function putInOrder(pairs:FoundPairs):int
        {
            // pairs whose rows on a side have the same index keep their order
            scatter(pairs, 1);
            scatter(pairs, 0);
            return pairs.haveTimes ? sortByTimes(pairs) : 0;
        }

        // Sorts by times. Pairs of the same time keep their order. Returns how many pairs touch before the end of their motions.
        private function sortByTimes(pairs:FoundPairs):int
        {
            var times:Vector.<Number> = pairs.times;
            var earlyCount:int = 0;
            _indices.count = 0;
            for (var i:int = 0; i < pairs.count; i++)
            {
                _indices.add(i, times[i]);
                if (times[i] < 1)
                {
                    earlyCount++;
                }
            }
            _indices.sortFirst(pairs.count);
            pairs.makeRoom(pairs.count);
            for (i = 0; i < pairs.count; i++)
            {
                var pair:int = _indices.values[i];
                pairs.spareRows[int(2 * i)] = pairs.rows[int(2 * pair)];
                pairs.spareRows[int(2 * i + 1)] = pairs.rows[int(2 * pair + 1)];
            }
            pairs.exchangeLists();
            return earlyCount;
        }

        // One step of a counting sort: puts the pairs into the order of the list indices of their first rows (side 0) or second rows (1). The times, if there
        // are any, go along.
        private function scatter(pairs:FoundPairs, side:int):void
        {
            findStarts(pairs, side);
            pairs.makeRoom(pairs.count);
            var to:Vector.<int> = pairs.spareRows;
            var next:Vector.<int> = _next;
            var listIndices:Vector.<int> = pairs.listed.listIndices;
            var from:Vector.<int> = pairs.rows;
            var times:Vector.<Number> = pairs.times;
            var timesTo:Vector.<Number> = pairs.spareTimes;
            var haveTimes:Boolean = pairs.haveTimes;
            var end:int = 2 * pairs.count;
            for (var i:int = 0; i < end; i += 2)
            {
                var index:int = listIndices[from[int(i + side)]];
                var at:int = next[index];
                next[index] = at + 2;
                to[at] = from[i];
                to[int(at + 1)] = from[int(i + 1)];
                if (haveTimes)
                {
                    timesTo[at >> 1] = times[i >> 1];
                }
            }
            pairs.exchangeLists();
        }

        // Finds by list index where the pairs begin whose rows on a side have it.
        private function findStarts(pairs:FoundPairs, side:int):void
        {
            // the ground and the edges of the world have the indices after those of the agents
            var indexCount:int = pairs.listed.rows.count + ListedAgents.ENVIRONMENT_ROW_COUNT;
            if (_next.length < indexCount)
            {
                _next.length = indexCount;
            }
            var next:Vector.<int> = _next;
            for (var index:int = 0; index < indexCount; index++)
            {
                next[index] = 0;
            }
            var rows:Vector.<int> = pairs.rows;
            var listIndices:Vector.<int> = pairs.listed.listIndices;
            var end:int = 2 * pairs.count;
            for (var i:int = side; i < end; i += 2)
            {
                next[listIndices[rows[i]]] += 2;
            }
            var start:int = 0;
            for (index = 0; index < indexCount; index++)
            {
                var ofIndex:int = next[index];
                next[index] = start;
                start += ofIndex;
            }
        }
    }
}
