package starlogo.search
{
    import starlogo.agents.Agent;
    import starlogo.data.IntList;
    import starlogo.data.SortableIntList;
    import starlogo.engine;
    import starlogo.search.table.ListedAgents;

    use namespace engine;

    /**
     * The pairs of a frame: two rows of agents each. After a search they are in the order of the list, by the first agent's index and then by the
     * second's. The ground and the edges of the world come after all agents. If an agent sweeps, pairs come by their times, and pairs of the same
     * time in the order of the list.
     *
     * <p>CollisionSearch adds pairs and sorts them. The pairs of a frame may be made from those of the last one. ForeignPairs adds the pairs of a
     * collision system that is not the engine's, which come in its own order.</p>
     *
     * @private
     */
    public final class FoundPairs
    {
        // If there are at least so many agents for each pair, comparing pairs is faster than counting those of each agent.
        private static const MANY_AGENTS:int = 12;

        // The factor of the first rank in a key of both ranks. All ranks are less.
        private static const RANK_FACTOR:Number = 1 << 26;

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

        // By pair, until the pairs are sorted: the time of the touch.
        private var _times:Vector.<Number> = new Vector.<Number>();

        // For sorting: the indices of the pairs in their new order, and their keys; or by rank, where the next pair goes whose row has it.
        private var _indices:SortableIntList = new SortableIntList();
        private var _next:Vector.<int> = new Vector.<int>();

        // Where pairs and their times go when their order changes. Then these lists are exchanged with those that they come from.
        private var _spare:Vector.<int> = new Vector.<int>();
        private var _spareTimes:Vector.<Number> = new Vector.<Number>();

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

        /**
         * Adds the pairs of a row. In each of them the agent that is first in the list comes first.
         *
         * @param times begins with the times at which the pairs touch, as others with their rows; null if no agent sweeps
         */
        internal function addPairs(row:int, others:Vector.<int>, othersCount:int, times:Vector.<Number>):void
        {
            if (times != null)
            {
                for (var k:int = 0; k < othersCount; k++)
                {
                    _times[int(count + k)] = times[k];
                }
            }
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

        /**
         * Puts the pairs into order.
         *
         * @param haveTimes whether an agent sweeps, so the pairs were added with times
         * @return how many pairs touch before the end of their motions. They come first
         */
        internal function putInOrder(haveTimes:Boolean):int
        {
            if (!areSorted())
            {
                sortByRanks(haveTimes);
            }
            return haveTimes ? sortByTimes() : 0;
        }

        /**
         * Changes the pairs to those of the next frame: drops the pairs of rows with a mark, and puts found pairs between the others.
         *
         * @param found the pairs of the rows with the mark, in order
         * @param earlyCount how many of these touch before the end of their motions. All other pairs touch at the end
         */
        internal function follow(marks:Vector.<int>, mark:int, found:FoundPairs, earlyCount:int):void
        {
            searches++;
            areKept = true;
            dropped.count = added.count = 0;
            makeRoom(count + found.count);
            var ranks:Vector.<int> = list.ranks;
            var pair:int = 0;
            for (var i:int = 0; i < found.count; i++)
            {
                var a:int = found.rows[2 * i];
                var b:int = found.rows[2 * i + 1];
                if (i >= earlyCount)
                {
                    pair = keepBefore(pair, ranks[a], ranks[b], marks, mark);
                }
                var to:int = pair - dropped.count + i;
                _spare[2 * to] = a;
                _spare[2 * to + 1] = b;
                added.add(to);
            }
            keepBefore(pair, int.MAX_VALUE, 0, marks, mark);
            count += found.count - dropped.count;
            exchangeLists();
        }

        // Copies the pairs from an index on up to a pair of two ranks, behind those that are copied or added already. Drops the pairs of rows with the
        // mark. Returns the index of the first pair after these two ranks.
        private function keepBefore(pair:int, first:int, second:int, marks:Vector.<int>, mark:int):int
        {
            var from:Vector.<int> = rows;
            var to:Vector.<int> = _spare;
            var ranks:Vector.<int> = list.ranks;
            var end:int = 2 * count;
            var next:int = 2 * (pair - dropped.count + added.count);
            for (var i:int = 2 * pair; i < end; i += 2)
            {
                var a:int = from[i];
                var b:int = from[int(i + 1)];
                if (marks[a] == mark || marks[b] == mark)
                {
                    dropped.add(i >> 1);
                    continue;
                }
                var rank:int = ranks[a];
                if (rank > first || rank == first && ranks[b] > second)
                {
                    return i >> 1;
                }
                to[next] = a;
                to[int(next + 1)] = b;
                next += 2;
            }
            return count;
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

        // Whether the pairs are in order already, as those of agents in one cell are.
        private function areSorted():Boolean
        {
            var all:Vector.<int> = rows;
            var ranks:Vector.<int> = list.ranks;
            var end:int = 2 * count;
            var row:int = -1;
            var first:int = -1;
            var last:int = -1;
            for (var i:int = 0; i < end; i += 2)
            {
                if (all[i] != row)
                {
                    row = all[i];
                    if (ranks[row] < first)
                    {
                        return false;
                    }
                    last = first = ranks[row];
                }
                var second:int = ranks[all[int(i + 1)]];
                if (second <= last)
                {
                    return false;
                }
                last = second;
            }
            return true;
        }

        private function sortByRanks(haveTimes:Boolean):void
        {
            if (MANY_AGENTS * count < list.rows.count)
            {
                sortByKeys(haveTimes);
                return;
            }
            // pairs whose rows on a side have the same rank keep their order
            scatter(1, haveTimes);
            scatter(0, haveTimes);
        }

        // Sorts by a key of both ranks.
        private function sortByKeys(haveTimes:Boolean):void
        {
            var ranks:Vector.<int> = list.ranks;
            _indices.count = 0;
            for (var i:int = 0; i < count; i++)
            {
                _indices.add(i, ranks[rows[2 * i]] * RANK_FACTOR + ranks[rows[2 * i + 1]]);
            }
            arrange(haveTimes);
        }

        // Sorts by times. Pairs of the same time keep their order. Returns how many pairs touch before the end of their motions.
        private function sortByTimes():int
        {
            var earlyCount:int = 0;
            _indices.count = 0;
            for (var i:int = 0; i < count; i++)
            {
                _indices.add(i, _times[i]);
                if (_times[i] < 1)
                {
                    earlyCount++;
                }
            }
            arrange(false);
            return earlyCount;
        }

        // Puts the pairs into the order of the keys. Their times go along if they are needed afterwards.
        private function arrange(haveTimes:Boolean):void
        {
            _indices.sortFirst(count);
            makeRoom(count);
            for (var i:int = 0; i < count; i++)
            {
                var pair:int = _indices.numbers[i];
                _spare[int(2 * i)] = rows[int(2 * pair)];
                _spare[int(2 * i + 1)] = rows[int(2 * pair + 1)];
                if (haveTimes)
                {
                    _spareTimes[i] = _times[pair];
                }
            }
            exchangeLists();
        }

        // Finds by rank where the pairs begin whose rows on a side have it.
        private function findStarts(side:int):void
        {
            // the ground and the edges of the world have the ranks after those of the agents
            var rankCount:int = list.rows.count + ListedAgents.FIRST_LISTED;
            if (_next.length < rankCount)
            {
                _next.length = rankCount;
            }
            var next:Vector.<int> = _next;
            for (var rank:int = 0; rank < rankCount; rank++)
            {
                next[rank] = 0;
            }
            var all:Vector.<int> = rows;
            var ranks:Vector.<int> = list.ranks;
            var end:int = 2 * count;
            for (var i:int = side; i < end; i += 2)
            {
                next[ranks[all[i]]] += 2;
            }
            var start:int = 0;
            for (rank = 0; rank < rankCount; rank++)
            {
                var ofRank:int = next[rank];
                next[rank] = start;
                start += ofRank;
            }
        }

        // One step of a counting sort: puts the pairs into the order of the ranks of their first rows (side 0) or second rows (1). The times, if there
        // are any, go along.
        private function scatter(side:int, haveTimes:Boolean):void
        {
            findStarts(side);
            makeRoom(count);
            var next:Vector.<int> = _next;
            var ranks:Vector.<int> = list.ranks;
            var from:Vector.<int> = rows;
            var to:Vector.<int> = _spare;
            var times:Vector.<Number> = _times;
            var timesTo:Vector.<Number> = _spareTimes;
            var end:int = 2 * count;
            for (var i:int = 0; i < end; i += 2)
            {
                var rank:int = ranks[from[int(i + side)]];
                var at:int = next[rank];
                next[rank] = at + 2;
                to[at] = from[i];
                to[int(at + 1)] = from[int(i + 1)];
                if (haveTimes)
                {
                    timesTo[at >> 1] = times[i >> 1];
                }
            }
            exchangeLists();
        }

        // Makes room for so many pairs in the spare lists.
        private function makeRoom(pairCount:int):void
        {
            if (_spare.length < 2 * pairCount)
            {
                // grows by an eighth, because a vector that grows a little in each frame is copied each time
                _spare.length = 2 * (pairCount + (pairCount >> 3));
            }
            if (_spareTimes.length < _times.length)
            {
                _spareTimes.length = _times.length;
            }
        }

        private function exchangeLists():void
        {
            var rowsBefore:Vector.<int> = rows;
            rows = _spare;
            _spare = rowsBefore;
            var timesBefore:Vector.<Number> = _times;
            _times = _spareTimes;
            _spareTimes = timesBefore;
        }
    }
}
