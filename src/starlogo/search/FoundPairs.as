package starlogo.search
{
    import starlogo.agents.Agent;
    import starlogo.data.IntList;
    import starlogo.engine;
    import starlogo.search.table.ListedAgents;

    use namespace engine;

    /**
     * The pairs of a frame: two rows of agents each. After a search they are in the order of the list, by the first agent's index and then by the
     * second's. The ground and the edges of the world come after all agents. If an agent sweeps, pairs that touch earlier come first.
     *
     * <p>CollisionSearch adds pairs, and PairSorter sorts them. The pairs of a frame may be made from those of the last one. ForeignPairs
     * adds the pairs of a collision system that is not the engine's, which come in its own order. Only PairSorter exchanges the rows.</p>
     *
     * @private
     */
    public final class FoundPairs
    {
        /** The number of pairs. */
        public var count:int = 0;

        /** The rows: a0, b0, a1, b1, ... The list may be longer: rows after the last pair are left over from earlier frames. */
        public var rows:Vector.<int> = new Vector.<int>();

        /** Has the agent of each row, and its rank in the list of the frame. */
        public var list:ListedAgents;

        /** How many searches have written their pairs here. */
        public var searches:int = 0;

        /** Whether these are the pairs of the search before, without the dropped pairs and with the added ones. */
        public var areKept:Boolean = false;

        /** If they are: the indices of the dropped pairs among the earlier pairs, in ascending order. */
        public var dropped:IntList = new IntList();

        /** The indices of the added pairs among these pairs, in ascending order. */
        public var added:IntList = new IntList();

        /** @param list has the agent of each row */
        public function FoundPairs(list:ListedAgents)
        {
            this.list = list;
        }

        /** Begins to write other pairs. */
        internal function begin():void
        {
            count = 0;
            searches++;
            areKept = false;
        }

        /** Adds a pair of two rows. */
        internal function add(a:int, b:int):void
        {
            rows[2 * count] = a;
            rows[2 * count + 1] = b;
            count++;
        }

        /** Adds the pairs of a row. In each of them the agent that is first in the list comes first. */
        internal function addPairs(row:int, others:Vector.<int>, othersCount:int):void
        {
            var to:int = 2 * count;
            var ranks:Vector.<int> = list.ranks;
            var rank:int = ranks[row];
            for (var i:int = 0; i < othersCount; i++)
            {
                // all bits of swaps are set if the other is first. Half of them are, so a branch would be mispredicted
                var swaps:int = (ranks[others[i]] - rank) >> 31;
                var change:int = (row ^ others[i]) & swaps;
                rows[to] = row ^ change;
                rows[int(to + 1)] = others[i] ^ change;
                to += 2;
            }
            count += othersCount;
        }

        /** Begins to change the pairs to those of the next frame: drops the pairs of rows with a mark. */
        internal function drop(marks:Vector.<int>, mark:int):void
        {
            searches++;
            areKept = true;
            dropped.count = added.count = 0;
            var all:Vector.<int> = rows;
            var end:int = 2 * count;
            var kept:int = 0;
            for (var i:int = 0; i < end; i += 2)
            {
                var a:int = all[i];
                var b:int = all[int(i + 1)];
                if (marks[a] != mark && marks[b] != mark)
                {
                    all[kept] = a;
                    all[int(kept + 1)] = b;
                    kept += 2;
                }
                else
                {
                    dropped.add(i >> 1);
                }
            }
            count = kept >> 1;
        }

        /**
         * Puts found pairs, which are in order, between the others.
         *
         * @param early the number of found pairs that come before all others
         */
        internal function merge(found:FoundPairs, early:int):void
        {
            var from:int = count;
            count += found.count;
            var to:int = count;
            if (rows.length < 2 * to)
            {
                // grows by an eighth, because a vector that grows a little in each frame is copied each time
                rows.length = 2 * (to + (to >> 3));
            }
            added.count = found.count;
            if (added.numbers.length < found.count)
            {
                added.numbers.length = found.count;
            }
            for (var i:int = found.count - 1; i >= 0; i--)
            {
                var a:int = found.rows[int(2 * i)];
                var b:int = found.rows[int(2 * i + 1)];
                for (var end:int = i < early ? 0 : indexFor(a, b, from); from > end; from--)
                {
                    to--;
                    rows[int(2 * to)] = rows[int(2 * from - 2)];
                    rows[int(2 * to + 1)] = rows[int(2 * from - 1)];
                }
                to--;
                added.numbers[i] = to;
                rows[int(2 * to)] = a;
                rows[int(2 * to + 1)] = b;
            }
        }

        /** The first agent of a pair. */
        public function firstOf(pair:int):Agent
        {
            return list.agents[rows[2 * pair]];
        }

        /** The second agent of a pair. */
        public function secondOf(pair:int):Agent
        {
            return list.agents[rows[2 * pair + 1]];
        }

        /** Writes the pairs as agents: a0, b0, a1, b1, ... */
        public function write(out:Vector.<Agent>):void
        {
            var byRow:Vector.<Agent> = list.agents;
            var all:Vector.<int> = rows;
            var end:int = 2 * count;
            var row:int = -1;
            var first:Agent = null;
            for (var i:int = 0; i < end; i += 2)
            {
                // in a dense crowd many pairs have the same first agent
                if (all[i] != row)
                {
                    row = all[i];
                    first = byRow[row];
                }
                out[i] = first;
                out[int(i + 1)] = byRow[all[int(i + 1)]];
            }
        }

        // The number of pairs before a pair, of the first pairs. It looks at the last of them first.
        private function indexFor(a:int, b:int, end:int):int
        {
            var high:int = end;
            var step:int = 1;
            while (high >= step && isAfter(high - step, a, b))
            {
                high -= step;
                step *= 2;
            }
            var low:int = high >= step ? high - step + 1 : 0;
            while (low < high)
            {
                var middle:int = (low + high) >> 1;
                if (isAfter(middle, a, b))
                {
                    high = middle;
                }
                else
                {
                    low = middle + 1;
                }
            }
            return low;
        }

        // Whether a pair comes after the pair of two rows.
        private function isAfter(pair:int, a:int, b:int):Boolean
        {
            var ranks:Vector.<int> = list.ranks;
            var ahead:int = ranks[rows[int(2 * pair)]] - ranks[a];
            return ahead > 0 || ahead == 0 && ranks[rows[int(2 * pair + 1)]] > ranks[b];
        }
    }
}
