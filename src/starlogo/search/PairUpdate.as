package starlogo.search
{
    import starlogo.data.IntSet;

    /** Makes the pairs of a search from those of the last one: drops the pairs of changed rows, and puts those between the others that were found now. */
    internal final class PairUpdate
    {
        /**
         * Replaces the pairs of changed rows, and notes the origins of the others.
         *
         * @param changed these rows
         * @param pairs the pairs of the last search, in order. They become those of the next
         * @param found the pairs of these rows, in order
         * @param earlyCount how many of the found pairs touch before the end of their motions. All others touch at the end
         */
        public function replacePairsOf(changed:IntSet, pairs:FoundPairs, found:FoundPairs, earlyCount:int):void
        {
            pairs.beginUpdate(pairs.count + found.count);
            var rows:Vector.<int> = pairs.rows;
            var added:int = 0;
            var kept:int = 0;
            for (var i:int = 0; i < pairs.count; i++)
            {
                var a:int = rows[int(2 * i)];
                var b:int = rows[int(2 * i + 1)];
                if (changed.has(a) || changed.has(b))
                {
                    continue;
                }
                while (added < found.count && (added < earlyCount || isBefore(found, added, a, b)))
                {
                    addNew(pairs, kept + added, found, added);
                    added++;
                }
                pairs.spareRows[int(2 * (kept + added))] = a;
                pairs.spareRows[int(2 * (kept + added) + 1)] = b;
                pairs.origins[int(kept + added)] = i;
                kept++;
            }
            for (; added < found.count; added++)
            {
                addNew(pairs, kept + added, found, added);
            }
            pairs.exchangeLists();
            pairs.count = kept + added;
        }

        // Whether a found pair comes before a pair of two rows in the order of the list.
        private static function isBefore(found:FoundPairs, pair:int, a:int, b:int):Boolean
        {
            var ranks:Vector.<int> = found.list.ranks;
            var rank:int = ranks[found.rows[int(2 * pair)]];
            return rank < ranks[a] || rank == ranks[a] && ranks[found.rows[int(2 * pair + 1)]] < ranks[b];
        }

        // Adds a found pair to the spare lists, at a place.
        private static function addNew(pairs:FoundPairs, to:int, found:FoundPairs, pair:int):void
        {
            pairs.spareRows[2 * to] = found.rows[2 * pair];
            pairs.spareRows[2 * to + 1] = found.rows[2 * pair + 1];
            pairs.origins[to] = FoundPairs.NEW;
        }
    }
}
