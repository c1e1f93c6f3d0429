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
        // If there are at least so many agents for each pair, comparing pairs is faster than counting those of each agent.
        private static const FEW:int = 12;

        // The factor of the first rank in a key of both. There are fewer ranks.
        private static const RANKS:Number = 1 << 26;

        // The pairs' numbers in their new order; in the order of their second agents; and the keys in the new order.
        private var _order:Vector.<int> = new Vector.<int>();
        private var _bySecond:Vector.<int> = new Vector.<int>();
        private var _keys:Vector.<Number> = new Vector.<Number>();
        private var _sort:KeySort = new KeySort();

        // By rank: how many pairs have it first or second, and then where the next of them goes.
        private var _firsts:Vector.<int> = new Vector.<int>();
        private var _seconds:Vector.<int> = new Vector.<int>();

        // The memory that the pairs had before.
        private var _spare:Vector.<int> = new Vector.<int>();

        /**
         * Puts pairs into order.
         *
         * @param haveTimes whether an agent sweeps
         * @return how many pairs touch before the end of their motions. They come first
         */
        public function sort(pairs:FoundPairs, haveTimes:Boolean):int
        {
            if (!haveTimes && areSorted(pairs))
            {
                return 0;
            }
            if (_order.length < pairs.count)
            {
                _order.length = _bySecond.length = _keys.length = pairs.count + (pairs.count >> 3);
            }
            orient(pairs);
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

        // Whether the pairs are in order already, as those of agents in one cell are.
        private function areSorted(pairs:FoundPairs):Boolean
        {
            var rows:Vector.<int> = pairs.rows;
            var ranks:Vector.<int> = pairs.ranks;
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

        // Puts the agent with the lesser rank first in each pair. All bits of swaps are set if that is the second. Half of them are, so a branch
        // would be mispredicted.
        private function orient(pairs:FoundPairs):void
        {
            var rows:Vector.<int> = pairs.rows;
            var ranks:Vector.<int> = pairs.ranks;
            var end:int = 2 * pairs.count;
            for (var i:int = 0; i < end; i += 2)
            {
                var a:int = rows[i];
                var b:int = rows[int(i + 1)];
                var swaps:int = (ranks[b] - ranks[a]) >> 31;
                var change:int = (a ^ b) & swaps;
                rows[i] = a ^ change;
                rows[int(i + 1)] = b ^ change;
            }
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

        // Two counting sorts, by the second ranks and then by the first. Each keeps the order of equals.
        private function sortByCounting(pairs:FoundPairs):void
        {
            countRanks(pairs);
            var rows:Vector.<int> = pairs.rows;
            var ranks:Vector.<int> = pairs.ranks;
            var bySecond:Vector.<int> = _bySecond;
            var order:Vector.<int> = _order;
            var next:Vector.<int> = _seconds;
            for (var i:int = 0; i < pairs.count; i++)
            {
                var rank:int = ranks[rows[int(2 * i + 1)]];
                bySecond[next[rank]] = i;
                next[rank]++;
            }
            next = _firsts;
            for (i = 0; i < pairs.count; i++)
            {
                var pair:int = bySecond[i];
                rank = ranks[rows[int(2 * pair)]];
                order[next[rank]] = pair;
                next[rank]++;
            }
        }

        // Finds where the pairs of each rank begin.
        private function countRanks(pairs:FoundPairs):void
        {
            // the ground and the edges of the world have the ranks after those of the agents
            var rankCount:int = pairs.agentCount + ListedAgents.LISTED;
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
            var ranks:Vector.<int> = pairs.ranks;
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
            var to:Vector.<int> = _spare;
            if (to.length < from.length)
            {
                to.length = from.length;
            }
            var order:Vector.<int> = _order;
            for (var i:int = 0; i < pairs.count; i++)
            {
                var pair:int = order[i];
                to[int(2 * i)] = from[int(2 * pair)];
                to[int(2 * i + 1)] = from[int(2 * pair + 1)];
            }
            pairs.rows = to;
            _spare = from;
        }
    }
}
