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

        /** The number of pairs that were found since the last <code>renew()</code>. */
        public var foundCount:int = 0;

        private var _table:AgentTable;
        private var _cells:CellLists;

        // The pairs, two rows for each, and their number.
        private var _pairs:Vector.<int> = new Vector.<int>();
        private var _count:int = 0;

        // The pairs that were found, two rows for each, their order, and how many of them touch before the end of their motions.
        private var _found:Vector.<int> = new Vector.<int>();
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
        public function read(found:FoundPairs, times:Vector.<Number>):void
        {
            var end:int = 2 * found.count;
            _count = foundCount = 0;
            for (var i:int = 0; i < end; i += 2)
            {
                if (times == null || times[i >> 1] == 1)
                {
                    _pairs[2 * _count] = rowAt(found.indices[i]);
                    _pairs[2 * _count + 1] = rowAt(found.indices[i + 1]);
                    _count++;
                }
            }
            noteWritten(found, _count == found.count);
        }

        /**
         * Adds pairs that were found.
         *
         * @param row the first row of each pair
         * @param rows the second rows are in this list
         * @param numbers begins with their indices in the list
         * @param count the number of pairs
         */
        public function add(row:int, rows:Vector.<int>, numbers:Vector.<int>, count:int):void
        {
            for (var i:int = 0; i < count; i++)
            {
                _found[2 * foundCount] = row;
                _found[2 * foundCount + 1] = rows[numbers[i]];
                foundCount++;
            }
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
            if (!isSource || out.droppedCount > 0 || foundCount > 0 || _writtenList != _table.listNumber)
            {
                write(out);
            }
            if (isSource && _early == 0)
            {
                out.origin = before;
            }
            foundCount = 0;
        }

        private function write(out:FoundPairs):void
        {
            out.begin();
            for (var i:int = 0; i < _early; i++)
            {
                writePairs(out, _found, _turns[i], _turns[i] + 1);
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
            out.droppedCount = 0;
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
                    out.dropped[out.droppedCount] = i >> 1;
                    out.droppedCount++;
                }
            }
            _count = kept >> 1;
        }

        // Sorts the found pairs by their times and then by their keys.
        private function sortFound(times:Vector.<Number>):void
        {
            for (var i:int = 0; i < foundCount; i++)
            {
                findKey(_found, i);
                _turns[i] = i;
                _keys[i] = _cells.secondKey;
            }
            // The sort keeps the order of equal keys. So the less important key is sorted first.
            _order.sort(_turns, _keys, foundCount);
            for (i = 0; i < foundCount; i++)
            {
                findKey(_found, _turns[i]);
                _keys[i] = _cells.key;
            }
            _order.sort(_turns, _keys, foundCount);
            _early = 0;
            if (times == null)
            {
                return;
            }
            for (i = 0; i < foundCount; i++)
            {
                _keys[i] = times[_turns[i]];
            }
            _order.sort(_turns, _keys, foundCount);
            while (_early < foundCount && _keys[_early] < 1)
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
            out.addedCount = foundCount - _early;
            if (out.added.length < out.addedCount)
            {
                out.added.length = out.addedCount;
            }
            _count += out.addedCount;
            var to:int = _count;
            if (pairs.length < 2 * to)
            {
                // grows by an eighth, because a vector that grows a little in each frame is copied each time
                pairs.length = 2 * (to + (to >> 3));
            }
            for (var i:int = foundCount - 1; i >= _early; i--)
            {
                var turn:int = _turns[i];
                findKey(_found, turn);
                var place:int = placeFor(_cells.key, _cells.secondKey, from);
                while (from > place)
                {
                    from--;
                    to--;
                    pairs[int(2 * to)] = pairs[int(2 * from)];
                    pairs[int(2 * to + 1)] = pairs[int(2 * from + 1)];
                }
                to--;
                out.added[int(i - _early)] = to;
                pairs[int(2 * to)] = _found[int(2 * turn)];
                pairs[int(2 * to + 1)] = _found[int(2 * turn + 1)];
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
