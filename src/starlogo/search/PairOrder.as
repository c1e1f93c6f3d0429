package starlogo.search
{
    import starlogo.data.SortableIntList;
    import starlogo.data.makeRoom;
    import starlogo.search.table.ListedAgents;

    /**
     * Puts the pairs of a search into order: by the list indices of their first agents, then of their second ones, and before that by their times if an
     * agent sweeps.
     */
    internal final class PairOrder
    {
        // The pairs in their order so far, by the indices at which they were found; and another list, for a step of the sort.
        private var _inOrder:SortableIntList = new SortableIntList();
        private var _other:Vector.<int> = new Vector.<int>();

        // By list index: where the next pair goes whose row on a side has the index, in a counting sort.
        private var _next:Vector.<int> = new Vector.<int>();

        /**
         * Puts pairs into order.
         *
         * @param times by pair: the time of the touch; null if no agent sweeps. The times stay as they are
         * @return how many pairs touch before the end of their motions. They come first
         */
        public function putInOrder(pairs:FoundPairs, times:Vector.<Number>):int
        {
            var order:Vector.<int> = _inOrder.values;
            for (var i:int = 0; i < pairs.count; i++)
            {
                order[i] = i;
            }
            // pairs whose rows on a side have the same index keep their order
            scatter(pairs, 1, order, _other);
            scatter(pairs, 0, _other, order);
            var earlyCount:int = times == null ? 0 : sortByTimes(pairs.count, times);
            pairs.reorder(order);
            return earlyCount;
        }

        // Sorts by times. Pairs of the same time keep their order. Returns how many pairs touch before the end of their motions.
        private function sortByTimes(count:int, times:Vector.<Number>):int
        {
            var earlyCount:int = 0;
            for (var i:int = 0; i < count; i++)
            {
                var time:Number = times[_inOrder.values[i]];
                _inOrder.keys[i] = time;
                if (time < 1)
                {
                    earlyCount++;
                }
            }
            _inOrder.sortFirst(count);
            return earlyCount;
        }

        // One step of a counting sort: puts the pairs into the order of the list indices of their first rows (side 0) or second rows (1).
        private function scatter(pairs:FoundPairs, side:int, from:Vector.<int>, to:Vector.<int>):void
        {
            findStarts(pairs, side);
            makeRoom(to, pairs.count);
            var next:Vector.<int> = _next;
            var listIndices:Vector.<int> = pairs.listed.listIndices;
            var rows:Vector.<int> = pairs.rows;
            for (var i:int = 0; i < pairs.count; i++)
            {
                var pair:int = from[i];
                var index:int = listIndices[rows[int(2 * pair + side)]];
                to[next[index]] = pair;
                next[index]++;
            }
        }

        // Finds by list index where the pairs begin whose rows on a side have it.
        private function findStarts(pairs:FoundPairs, side:int):void
        {
            // the edges of the world have the last index
            var indexCount:int = pairs.listed.listIndices[ListedAgents.EDGES_ROW] + 1;
            makeRoom(_next, indexCount);
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
                next[listIndices[rows[i]]]++;
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
