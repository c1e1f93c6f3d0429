package starlogo.search
{
    /**
     * Puts pairs into the order of the list: in a pair, the agent that is first in the list comes first; pairs come by the first agent's index and
     * then by the second's. If an agent sweeps, they come by their times, and pairs of the same time in the order of the list.
     *
     * @private
     */
    public final class PairOrder
    {
        // If there are at least so many agents for each pair, sorting by comparing is faster than counting by agent.
        private static const FEW:int = 4;

        // The factor of the first rank in a key of both. There are fewer ranks.
        private static const RANKS:Number = 1 << 26;

        // The pairs' numbers in their new order, and in the order of the second ranks.
        private var _order:Vector.<int> = new Vector.<int>();
        private var _bySecond:Vector.<int> = new Vector.<int>();

        // By rank: how many pairs have it, and then where the next of them goes.
        private var _firsts:Vector.<int> = new Vector.<int>();
        private var _seconds:Vector.<int> = new Vector.<int>();

        // By place in the order.
        private var _keys:Vector.<Number> = new Vector.<Number>();
        private var _sort:KeySort = new KeySort();

        // The memory that the pairs had before, for the next order.
        private var _spareRows:Vector.<int> = new Vector.<int>();

        /**
         * Puts pairs into order.
         *
         * @param haveTimes whether an agent sweeps
         * @return how many pairs touch before the end of their motions. They come first
         */
        public function sort(pairs:FoundPairs, haveTimes:Boolean):int
        {
            var areSorted:Boolean = orient(pairs);
            if (areSorted && !haveTimes)
            {
                return 0;
            }
            if (_order.length < pairs.count)
            {
                _order.length = _bySecond.length = _keys.length = pairs.count + (pairs.count >> 3);
            }
            if (FEW * pairs.count < pairs.agentCount)
            {
                sortByKeys(pairs);
            }
            else
            {
                sortByCounting(pairs);
            }
            var early:int = haveTimes ? sortByTimes(pairs) : 0;
            arrange(pairs);
            return early;
        }

        // Puts the agent with the lesser rank first in each pair. Returns whether the pairs are in order, as those of one cell are.
        private function orient(pairs:FoundPairs):Boolean
        {
            var rows:Vector.<int> = pairs.rows;
            var ranks:Vector.<int> = pairs.ranks;
            var end:int = 2 * pairs.count;
            var lastFirst:int = -1;
            var lastSecond:int = -1;
            var areSorted:Boolean = true;
            for (var i:int = 0; i < end; i += 2)
            {
                var first:int = ranks[rows[i]];
                var second:int = ranks[rows[int(i + 1)]];
                if (first > second)
                {
                    var row:int = rows[i];
                    rows[i] = rows[int(i + 1)];
                    rows[int(i + 1)] = row;
                    row = first;
                    first = second;
                    second = row;
                }
                if (first < lastFirst || first == lastFirst && second < lastSecond)
                {
                    areSorted = false;
                }
                lastFirst = first;
                lastSecond = second;
            }
            return areSorted;
        }

        private function sortByKeys(pairs:FoundPairs):void
        {
            var rows:Vector.<int> = pairs.rows;
            var ranks:Vector.<int> = pairs.ranks;
            for (var i:int = 0; i < pairs.count; i++)
            {
                _order[i] = i;
                _keys[i] = ranks[rows[2 * i]] * RANKS + ranks[rows[2 * i + 1]];
            }
            _sort.sort(_order, _keys, pairs.count);
        }

        // Two counting sorts, which keep the order of equals: first by the second rank, then by the first.
        private function sortByCounting(pairs:FoundPairs):void
        {
            count(pairs);
            var rows:Vector.<int> = pairs.rows;
            var ranks:Vector.<int> = pairs.ranks;
            var bySecond:Vector.<int> = _bySecond;
            var order:Vector.<int> = _order;
            var ends:Vector.<int> = _seconds;
            for (var i:int = 0; i < pairs.count; i++)
            {
                var rank:int = ranks[rows[int(2 * i + 1)]];
                bySecond[ends[rank]] = i;
                ends[rank]++;
            }
            ends = _firsts;
            for (i = 0; i < pairs.count; i++)
            {
                var pair:int = bySecond[i];
                rank = ranks[rows[int(2 * pair)]];
                order[ends[rank]] = pair;
                ends[rank]++;
            }
        }

        // Finds where the pairs of each rank begin.
        private function count(pairs:FoundPairs):void
        {
            var firsts:Vector.<int> = _firsts;
            var seconds:Vector.<int> = _seconds;
            // the ground and the edges of the world have the ranks after those of the agents
            var length:int = pairs.agentCount + RowList.LISTED;
            if (firsts.length < length)
            {
                firsts.length = seconds.length = length;
            }
            for (var rank:int = 0; rank < length; rank++)
            {
                firsts[rank] = seconds[rank] = 0;
            }
            var rows:Vector.<int> = pairs.rows;
            var ranks:Vector.<int> = pairs.ranks;
            var end:int = 2 * pairs.count;
            for (var i:int = 0; i < end; i += 2)
            {
                firsts[ranks[rows[i]]]++;
                seconds[ranks[rows[int(i + 1)]]]++;
            }
            var firstsBefore:int = 0;
            var secondsBefore:int = 0;
            for (rank = 0; rank < length; rank++)
            {
                var ofRank:int = firsts[rank];
                firsts[rank] = firstsBefore;
                firstsBefore += ofRank;
                ofRank = seconds[rank];
                seconds[rank] = secondsBefore;
                secondsBefore += ofRank;
            }
        }

        // Sorts by the times. Equal times keep their order. Returns how many come before the end.
        private function sortByTimes(pairs:FoundPairs):int
        {
            for (var i:int = 0; i < pairs.count; i++)
            {
                _keys[i] = pairs.times[_order[i]];
            }
            _sort.sort(_order, _keys, pairs.count);
            var early:int = 0;
            while (early < pairs.count && _keys[early] < 1)
            {
                early++;
            }
            return early;
        }

        private function arrange(pairs:FoundPairs):void
        {
            var from:Vector.<int> = pairs.rows;
            var to:Vector.<int> = _spareRows;
            if (to.length < from.length)
            {
                to.length = from.length;
            }
            for (var i:int = 0; i < pairs.count; i++)
            {
                var pair:int = _order[i];
                to[int(2 * i)] = from[int(2 * pair)];
                to[int(2 * i + 1)] = from[int(2 * pair + 1)];
            }
            pairs.rows = to;
            _spareRows = from;
        }
    }
}
