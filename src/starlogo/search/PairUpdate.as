package starlogo.search
{
    import starlogo.data.IntSet;

    /** Makes the pairs of a search from those of the last one: drops the pairs of changed rows, and puts those between the others that were found now. */
    internal final class PairUpdate
    {
        /**
         * Replaces the pairs of changed rows.
         *
         * @param changed these rows
         * @param pairs the pairs of the last search, in order. They become those of the next
         * @param found the pairs of these rows, in order
         * @param earlyCount how many of the found pairs touch before the end of their motions. All others touch at the end
         */
        public function replacePairsOf(changed:IntSet, pairs:FoundPairs, found:FoundPairs, earlyCount:int):void
        {
            pairs.beginKept();
            pairs.makeRoom(pairs.count + found.count);
            var to:Vector.<int> = pairs.spareRows;
            var ranks:Vector.<int> = pairs.list.ranks;
            var next:int = 0;
            for (var i:int = 0; i < found.count; i++)
            {
                var a:int = found.rows[2 * i];
                var b:int = found.rows[2 * i + 1];
                if (i >= earlyCount)
                {
                    next = keepBefore(ranks[a], ranks[b], pairs, next, changed, to);
                }
                var pair:int = next - pairs.dropped.count + i;
                to[2 * pair] = a;
                to[2 * pair + 1] = b;
                pairs.added.add(pair);
            }
            keepBefore(int.MAX_VALUE, 0, pairs, next, changed, to);
            pairs.endKept();
        }

        // Copies the pairs from an index on up to a pair of two ranks, behind those that are copied or added already. Drops the pairs of changed rows.
        // Returns the index of the first pair after these two ranks.
        private static function keepBefore(firstRank:int, secondRank:int, pairs:FoundPairs, start:int, changed:IntSet, to:Vector.<int>):int
        {
            var from:Vector.<int> = pairs.rows;
            var ranks:Vector.<int> = pairs.list.ranks;
            var marks:Vector.<int> = changed.marks;
            var mark:int = changed.mark;
            var end:int = 2 * pairs.count;
            var next:int = 2 * (start - pairs.dropped.count + pairs.added.count);
            for (var i:int = 2 * start; i < end; i += 2)
            {
                var a:int = from[i];
                var b:int = from[int(i + 1)];
                if (marks[a] == mark || marks[b] == mark)
                {
                    pairs.dropped.add(i >> 1);
                    continue;
                }
                var rank:int = ranks[a];
                if (rank > firstRank || rank == firstRank && ranks[b] > secondRank)
                {
                    return i >> 1;
                }
                to[next] = a;
                to[int(next + 1)] = b;
                next += 2;
            }
            return pairs.count;
        }
    }
}
