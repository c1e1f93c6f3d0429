package starlogo.search
{
    import starlogo.data.IntSet;

    /** Makes the pairs of a frame from those of the last one: drops the pairs of changed rows, and puts those between the others that were found now. */
    internal final class PairUpdate
    {
        // Where the pairs of the frame go. Then it is exchanged with the list of the pairs.
        private var _spareRows:Vector.<int> = new Vector.<int>();

        /**
         * Replaces the pairs of changed rows.
         *
         * @param changed these rows
         * @param pairs the pairs of the last frame, in order. They become those of the next
         * @param found the pairs of these rows, in order
         * @param earlyCount how many of the found pairs touch before the end of their motions. All others touch at the end
         */
        public function replacePairsOf(changed:IntSet, pairs:FoundPairs, found:FoundPairs, earlyCount:int):void
        {
            pairs.beginKept();
            var mostPairs:int = pairs.count + found.count;
            if (_spareRows.length < 2 * mostPairs)
            {
                // grows by an eighth, because a vector that grows a little in each frame is copied each time
                _spareRows.length = 2 * (mostPairs + (mostPairs >> 3));
            }
            var ranks:Vector.<int> = pairs.list.ranks;
            var next:int = 0;
            for (var i:int = 0; i < found.count; i++)
            {
                var a:int = found.rows[2 * i];
                var b:int = found.rows[2 * i + 1];
                if (i >= earlyCount)
                {
                    next = keepBefore(ranks[a], ranks[b], pairs, next, changed);
                }
                var to:int = next - pairs.dropped.count + i;
                _spareRows[2 * to] = a;
                _spareRows[2 * to + 1] = b;
                pairs.added.add(to);
            }
            keepBefore(int.MAX_VALUE, 0, pairs, next, changed);
            _spareRows = pairs.endKept(_spareRows);
        }

        // Copies the pairs from an index on up to a pair of two ranks, behind those that are copied or added already. Drops the pairs of changed rows.
        // Returns the index of the first pair after these two ranks.
        private function keepBefore(firstRank:int, secondRank:int, pairs:FoundPairs, start:int, changed:IntSet):int
        {
            var from:Vector.<int> = pairs.rows;
            var to:Vector.<int> = _spareRows;
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
