package starlogo.search
{
    import starlogo.broadphase.CellLists;

    /**
     * The pairs of a search, as rows, in the order in which the bins find them. The pairs of changed rows are dropped and found again, and those that
     * were found come between the others.
     *
     * <p>In a search with sweeping agents, pairs that touch before the end of their motions are written first, by their times. They are not kept, because
     * one of their rows has moved.</p>
     */
    internal final class OrderedPairs
    {
        // The first part of the key of a pair with the ground or the edges, which come after all other pairs.
        private static const LAST:Number = 1e15;

        /** The pairs that the search under way has found. <code>renew()</code> makes rows of their indices. */
        public var found:FoundPairs = new FoundPairs();

        private var _table:AgentTable;
        private var _cells:CellLists;

        // The pairs, two rows for each, and their number.
        private var _pairs:Vector.<int> = new Vector.<int>();
        private var _count:int = 0;

        // The order of the pairs that were found, and how many of them touch before the end of their motions.
        private var _turns:Vector.<int> = new Vector.<int>();
        private var _keys:Vector.<Number> = new Vector.<Number>();
        private var _order:KeySort = new KeySort();
        private var _early:int = 0;

        // The list with whose ranks they were written last.
        private var _writtenList:int = -1;

        /**
         * @param table has the ranks of the rows
         * @param cells has the keys of pairs
         */
        public function OrderedPairs(table:AgentTable, cells:CellLists)
        {
            _table = table;
            _cells = cells;
        }

        /**
         * Takes the pairs of a search of all rows.
         *
         * @param times their times; null if no agent sweeps
         */
        public function read(all:FoundPairs, times:Vector.<Number>):void
        {
            var end:int = 2 * all.count;
            _count = 0;
            for (var i:int = 0; i < end; i += 2)
            {
                if (times == null || times[i >> 1] == 1)
                {
                    _pairs[2 * _count] = rowAt(all.indices[i]);
                    _pairs[2 * _count + 1] = rowAt(all.indices[i + 1]);
                    _count++;
                }
            }
            noteWritten(all, _count == all.count);
        }

        /**
         * Drops the pairs of rows with a mark, and puts the found pairs between the others.
         *
         * @param marks by row
         * @param mark the mark
         * @param times the times of the found pairs; null if no agent sweeps
         * @param out takes the pairs. It is left as it is if they are there already
         */
        public function renew(marks:Vector.<int>, mark:int, times:Vector.<Number>, out:FoundPairs):void
        {
            drop(marks, mark, out);
            sortFound(times);
            merge(out);
            var isSource:Boolean = out.keeper === this;
            var before:int = out.number;
            if (!isSource || out.dropped.count > 0 || found.count > 0 || _writtenList != _table.listNumber)
            {
                write(out);
            }
            if (isSource && _early == 0)
            {
                out.origin = before;
            }
        }

        private function write(out:FoundPairs):void
        {
            out.begin();
            for (var i:int = 0; i < _early; i++)
            {
                writePairs(out, found.indices, _turns[i], _turns[i] + 1);
            }
            writePairs(out, _pairs, 0, _count);
            noteWritten(out, _early == 0);
        }

        private function noteWritten(out:FoundPairs, areAll:Boolean):void
        {
            out.keeper = areAll ? this : null;
            _writtenList = _table.listNumber;
        }

        private function rowAt(rank:int):int
        {
            return rank < _table.count ? _table.rows[rank] : rank - _table.count;
        }

        private function drop(marks:Vector.<int>, mark:int, out:FoundPairs):void
        {
            var pairs:Vector.<int> = _pairs;
            var end:int = 2 * _count;
            var kept:int = 0;
            out.dropped.count = 0;
            for (var i:int = 0; i < end; i += 2)
            {
                var a:int = pairs[i];
                var b:int = pairs[int(i + 1)];
                if (marks[a] != mark && marks[b] != mark)
                {
                    pairs[kept] = a;
                    pairs[int(kept + 1)] = b;
                    kept += 2;
                }
                else
                {
                    out.dropped.add(i >> 1);
                }
            }
            _count = kept >> 1;
        }

        // Sorts the found pairs by their times and then by their keys.
        private function sortFound(times:Vector.<Number>):void
        {
            var indices:Vector.<int> = found.indices;
            for (var i:int = 0; i < found.count; i++)
            {
                indices[2 * i] = rowAt(indices[2 * i]);
                indices[2 * i + 1] = rowAt(indices[2 * i + 1]);
                findKey(indices, i);
                _turns[i] = i;
                _keys[i] = _cells.secondKey;
            }
            // The sort keeps the order of equal keys. So the less important key is sorted first.
            _order.sort(_turns, _keys, found.count);
            for (i = 0; i < found.count; i++)
            {
                findKey(indices, _turns[i]);
                _keys[i] = _cells.key;
            }
            _order.sort(_turns, _keys, found.count);
            _early = 0;
            if (times == null)
            {
                return;
            }
            for (i = 0; i < found.count; i++)
            {
                _keys[i] = times[_turns[i]];
            }
            _order.sort(_turns, _keys, found.count);
            while (_early < found.count && _keys[_early] < 1)
            {
                _early++;
            }
        }

        private function findKey(pairs:Vector.<int>, index:int):void
        {
            var a:int = pairs[2 * index];
            var b:int = pairs[2 * index + 1];
            if (a >= RowList.LISTED && b >= RowList.LISTED)
            {
                _cells.findKey(a, b, _table.ranks);
                return;
            }
            var fixture:int = a < b ? a : b;
            _cells.key = LAST + fixture;
            _cells.secondKey = _table.ranks[a + b - fixture];
        }

        // Puts the found pairs between the others, from the last one on.
        private function merge(out:FoundPairs):void
        {
            var pairs:Vector.<int> = _pairs;
            var from:int = _count;
            out.added.count = found.count - _early;
            var added:Vector.<int> = out.added.numbers;
            if (added.length < out.added.count)
            {
                added.length = out.added.count;
            }
            _count += out.added.count;
            var to:int = _count;
            if (pairs.length < 2 * to)
            {
                // grows by an eighth, because a vector that grows a little in each frame is copied each time
                pairs.length = 2 * (to + (to >> 3));
            }
            for (var i:int = found.count - 1; i >= _early; i--)
            {
                var turn:int = _turns[i];
                findKey(found.indices, turn);
                var place:int = placeFor(_cells.key, _cells.secondKey, from);
                while (from > place)
                {
                    from--;
                    to--;
                    pairs[int(2 * to)] = pairs[int(2 * from)];
                    pairs[int(2 * to + 1)] = pairs[int(2 * from + 1)];
                }
                to--;
                added[int(i - _early)] = to;
                pairs[int(2 * to)] = found.indices[int(2 * turn)];
                pairs[int(2 * to + 1)] = found.indices[int(2 * turn + 1)];
            }
        }

        // The number of pairs before a key, of the first pairs. It looks at the last of them first.
        private function placeFor(key:Number, secondKey:Number, count:int):int
        {
            var high:int = count;
            var step:int = 1;
            while (high >= step && isAfter(high - step, key, secondKey))
            {
                high -= step;
                step *= 2;
            }
            var low:int = high >= step ? high - step + 1 : 0;
            while (low < high)
            {
                var middle:int = (low + high) >> 1;
                if (isAfter(middle, key, secondKey))
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

        private function isAfter(index:int, key:Number, secondKey:Number):Boolean
        {
            findKey(_pairs, index);
            return _cells.key > key || _cells.key == key && _cells.secondKey > secondKey;
        }

        private function writePairs(out:FoundPairs, pairs:Vector.<int>, first:int, end:int):void
        {
            var ranks:Vector.<int> = _table.ranks;
            var indices:Vector.<int> = out.indices;
            var at:int = 2 * out.count;
            out.count += end - first;
            for (var i:int = 2 * first; i < 2 * end; i += 2)
            {
                var a:int = ranks[pairs[i]];
                var b:int = ranks[pairs[int(i + 1)]];
                indices[at] = a < b ? a : b;
                indices[int(at + 1)] = a < b ? b : a;
                at += 2;
            }
        }
    }
}
