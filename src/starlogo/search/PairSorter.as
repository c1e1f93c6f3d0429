package starlogo.search
{
    import starlogo.data.SortableIntList;
    import starlogo.search.table.ListedAgents;

    /**
     * Puts pairs into the order of the list: by the first agent's index and then by the second's. If an agent
     * sweeps, they come by their times, and pairs of the same time in the order of the list.
     *
     * @private
     */
    public final class PairSorter
    {
        // If there are at least so many agents for each pair, comparing pairs is faster than counting those of each agent.
        private static const MANY_AGENTS:int = 12;

        // The factor of the first rank in a key of both ranks. All ranks are less.
        private static const RANK_FACTOR:Number = 1 << 26;

        // The indices of the pairs in their new order, and their keys.
        private var _indices:SortableIntList = new SortableIntList();

        // By rank: where the next pair goes whose first row has it, and where the next one goes whose second row has it.
        private var _firsts:Vector.<int> = new Vector.<int>();
        private var _seconds:Vector.<int> = new Vector.<int>();

        // The memory that the pairs had before, and room for their times.
        private var _spare:Vector.<int> = new Vector.<int>();
        private var _spareTimes:Vector.<Number> = new Vector.<Number>();

        /**
         * Puts pairs into order.
         *
         * @param times by pair: the time of the touch; null if no agent sweeps. They mean nothing afterwards
         */
        public function sort(pairs:FoundPairs, times:Vector.<Number>):void
        {
            if (times == null && areSorted(pairs))
            {
                return;
            }
            if (MANY_AGENTS * pairs.count < pairs.list.rows.count)
            {
                sortByKeys(pairs, times);
                return;
            }
            var timesBySecond:Vector.<Number> = times == null ? null : _spareTimes;
            countRanks(pairs);
            scatter(pairs, 1, _seconds, times, timesBySecond);
            scatter(pairs, 0, _firsts, timesBySecond, times);
            if (times != null)
            {
                sortByTimes(pairs, times);
            }
        }

        // Whether the pairs are in order already, as those of agents in one cell are.
        private function areSorted(pairs:FoundPairs):Boolean
        {
            var rows:Vector.<int> = pairs.rows;
            var ranks:Vector.<int> = pairs.list.ranks;
            var end:int = 2 * pairs.count;
            var row:int = -1;
            var first:int = -1;
            var last:int = -1;
            for (var i:int = 0; i < end; i += 2)
            {
                if (rows[i] != row)
                {
                    row = rows[i];
                    if (ranks[row] < first)
                    {
                        return false;
                    }
                    last = first = ranks[row];
                }
                var second:int = ranks[rows[int(i + 1)]];
                if (second <= last)
                {
                    return false;
                }
                last = second;
            }
            return true;
        }

        // Sorts by a key of both ranks, and then by times, if there are any.
        private function sortByKeys(pairs:FoundPairs, times:Vector.<Number>):void
        {
            var rows:Vector.<int> = pairs.rows;
            var ranks:Vector.<int> = pairs.list.ranks;
            _indices.count = 0;
            for (var i:int = 0; i < pairs.count; i++)
            {
                _indices.add(i, ranks[rows[2 * i]] * RANK_FACTOR + ranks[rows[2 * i + 1]]);
            }
            _indices.sortFirst(pairs.count);
            if (times != null)
            {
                for (i = 0; i < pairs.count; i++)
                {
                    _indices.keys[i] = times[_indices.numbers[i]];
                }
                _indices.sortFirst(pairs.count);
            }
            arrange(pairs);
        }

        // Sorts by times. Pairs of the same time keep their order.
        private function sortByTimes(pairs:FoundPairs, times:Vector.<Number>):void
        {
            _indices.count = 0;
            for (var i:int = 0; i < pairs.count; i++)
            {
                _indices.add(i, times[i]);
            }
            _indices.sortFirst(pairs.count);
            arrange(pairs);
        }

        // One step of a counting sort: puts the pairs into the order of the ranks of their first rows (side 0) or second rows (1). Equals keep their
        // order, so sorting by the second rows and then by the first ones sorts by both. The times, if there are any, go to another list.
        private function scatter(pairs:FoundPairs, side:int, next:Vector.<int>, times:Vector.<Number>, timesTo:Vector.<Number>):void
        {
            makeRoom(pairs);
            var ranks:Vector.<int> = pairs.list.ranks;
            var from:Vector.<int> = pairs.rows;
            var to:Vector.<int> = _spare;
            var end:int = 2 * pairs.count;
            if (times != null && timesTo.length < pairs.count)
            {
                timesTo.length = times.length;
            }
            for (var i:int = 0; i < end; i += 2)
            {
                var rank:int = ranks[from[int(i + side)]];
                var at:int = next[rank];
                next[rank] = at + 2;
                to[at] = from[i];
                to[int(at + 1)] = from[int(i + 1)];
                if (times != null)
                {
                    timesTo[at >> 1] = times[i >> 1];
                }
            }
            exchange(pairs);
        }

        // Finds where the pairs of each rank begin.
        private function countRanks(pairs:FoundPairs):void
        {
            // the ground and the edges of the world have the ranks after those of the agents
            var rankCount:int = pairs.list.rows.count + ListedAgents.FIRST_LISTED;
            if (_firsts.length < rankCount)
            {
                _firsts.length = _seconds.length = rankCount;
            }
            var firsts:Vector.<int> = _firsts;
            var seconds:Vector.<int> = _seconds;
            for (var rank:int = 0; rank < rankCount; rank++)
            {
                firsts[rank] = seconds[rank] = 0;
            }
            var rows:Vector.<int> = pairs.rows;
            var ranks:Vector.<int> = pairs.list.ranks;
            var end:int = 2 * pairs.count;
            for (var i:int = 0; i < end; i += 2)
            {
                firsts[ranks[rows[i]]]++;
                seconds[ranks[rows[int(i + 1)]]]++;
            }
            var firstsBefore:int = 0;
            var secondsBefore:int = 0;
            for (rank = 0; rank < rankCount; rank++)
            {
                var ofRank:int = firsts[rank];
                firsts[rank] = firstsBefore;
                firstsBefore += 2 * ofRank;
                ofRank = seconds[rank];
                seconds[rank] = secondsBefore;
                secondsBefore += 2 * ofRank;
            }
        }

        // Puts the pairs into the order of the indices.
        private function arrange(pairs:FoundPairs):void
        {
            makeRoom(pairs);
            var from:Vector.<int> = pairs.rows;
            for (var i:int = 0; i < pairs.count; i++)
            {
                var pair:int = _indices.numbers[i];
                _spare[int(2 * i)] = from[int(2 * pair)];
                _spare[int(2 * i + 1)] = from[int(2 * pair + 1)];
            }
            exchange(pairs);
        }

        private function makeRoom(pairs:FoundPairs):void
        {
            if (_spare.length < pairs.rows.length)
            {
                _spare.length = pairs.rows.length;
            }
        }

        private function exchange(pairs:FoundPairs):void
        {
            var rows:Vector.<int> = pairs.rows;
            pairs.rows = _spare;
            _spare = rows;
        }
    }
}
