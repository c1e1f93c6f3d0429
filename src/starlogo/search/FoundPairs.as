package starlogo.search
{
    import starlogo.agents.Agent;
    import starlogo.convex.RelativeMotion;
    import starlogo.data.IntSet;
    import starlogo.data.SortableIntList;
    import starlogo.data.makeRoom;
    import starlogo.engine;
    import starlogo.search.table.ListedAgents;

    use namespace engine;

    /**
     * The pairs of a search: two rows of agents each. After the search they are in the order of the list, by the first agent's index and then by the
     * second's. The ground and the edges of the world come after all agents. If an agent sweeps, pairs come by their times, and pairs of the same
     * time in the order of the list. The pairs of a collision system that is not the engine's come in its own order.
     *
     * <p>Tests add pairs row by row, and <code>putInOrder()</code> sorts them. If few rows have changed since the last search, their pairs are put
     * between the others (<code>replacePairsOf()</code>).</p>
     *
     * @private
     */
    public final class FoundPairs
    {
        /** In place of the index of a touch: the pair has none, or none yet. */
        public static const NO_TOUCH:int = -1;

        /** The number of pairs. */
        public var count:int = 0;

        /** The rows: a0, b0, a1, b1, ... The list may be longer: rows after the last pair are left over from earlier searches. */
        public var rows:Vector.<int> = new Vector.<int>();

        /** Has the agent of each row, and its index in the list of the search. */
        public var listed:ListedAgents;

        /** By pair: the index of its touch, which the TouchTracker writes, or NO_TOUCH. Pairs that are kept for the next search keep it. */
        public var touchIndices:Vector.<int> = new Vector.<int>();

        // By pair: the time of the touch, until putInOrder(), if an agent sweeps.
        private var _times:Vector.<Number> = new Vector.<Number>();

        // The back buffers of rows and touchIndices: other pairs, or the pairs in another order, are written here before swapBuffers().
        private var _backRows:Vector.<int> = new Vector.<int>();
        private var _backTouchIndices:Vector.<int> = new Vector.<int>();

        // While pairs are put into order: the pairs in their order so far, by the indices at which they were found; and another list, for a step of the sort.
        private var _inOrder:SortableIntList = new SortableIntList();
        private var _otherOrder:Vector.<int> = new Vector.<int>();

        // By list index: where the next pair goes whose row on a side has the index, in a counting sort.
        private var _next:Vector.<int> = new Vector.<int>();

        /** @param listed has the agent of each row */
        public function FoundPairs(listed:ListedAgents)
        {
            this.listed = listed;
        }

        /** Lets no pair have a touch. Call it if the touches may be those of another Collision. */
        public function forgetTouches():void
        {
            for (var i:int = 0; i < count; i++)
            {
                touchIndices[i] = NO_TOUCH;
            }
        }

        /**
         * Becomes the pairs of a search that is an update of the last one: drops the pairs of changed rows, and puts those between the others that were
         * found now.
         *
         * @param changed the changed rows
         * @param found their pairs, in order
         * @param earlyCount how many of the found pairs touch before the end of their motions. All others touch at the end
         */
        internal function replacePairsOf(changed:IntSet, found:FoundPairs, earlyCount:int):void
        {
            makeRoom(_backRows, 2 * (count + found.count));
            makeRoom(_backTouchIndices, count + found.count);
            var added:int = 0;
            var kept:int = 0;
            for (var i:int = 0; i < count; i++)
            {
                var a:int = rows[int(2 * i)];
                var b:int = rows[int(2 * i + 1)];
                if (changed.has(a) || changed.has(b))
                {
                    continue;
                }
                while (added < found.count && (added < earlyCount || found.isBefore(added, a, b)))
                {
                    write(kept + added, found.rows[int(2 * added)], found.rows[int(2 * added + 1)], NO_TOUCH);
                    added++;
                }
                write(kept + added, a, b, touchIndices[i]);
                kept++;
            }
            for (; added < found.count; added++)
            {
                write(kept + added, found.rows[int(2 * added)], found.rows[int(2 * added + 1)], NO_TOUCH);
            }
            swapBuffers();
            count = kept + added;
        }

        /**
         * Puts pairs that were all found anew into order. They have no touches then.
         *
         * @param anySweeps whether an agent sweeps, so that the pairs have times
         * @return how many pairs touch before the end of their motions. They come first
         */
        internal function putInOrder(anySweeps:Boolean):int
        {
            var order:Vector.<int> = _inOrder.values;
            for (var i:int = 0; i < count; i++)
            {
                order[i] = i;
            }
            // pairs whose rows on a side have the same index keep their order
            scatter(1, order, _otherOrder);
            scatter(0, _otherOrder, order);
            var earlyCount:int = anySweeps ? sortByTimes() : 0;
            reorder(order);
            return earlyCount;
        }

        // Sorts by times. Pairs of the same time keep their order. Returns how many pairs touch before the end of their motions.
        private function sortByTimes():int
        {
            var earlyCount:int = 0;
            for (var i:int = 0; i < count; i++)
            {
                var time:Number = _times[_inOrder.values[i]];
                _inOrder.keys[i] = time;
                if (time < 1)
                {
                    earlyCount++;
                }
            }
            _inOrder.sortFirst(count);
            return earlyCount;
        }

        // One step of a counting sort: puts the pairs into the order of the list indices of their first rows (side 0) or second rows (1).
        private function scatter(side:int, from:Vector.<int>, to:Vector.<int>):void
        {
            findStarts(side);
            makeRoom(to, count);
            var next:Vector.<int> = _next;
            var indices:Vector.<int> = listed.listIndices;
            var pairRows:Vector.<int> = rows;
            for (var i:int = 0; i < count; i++)
            {
                var pair:int = from[i];
                var index:int = indices[pairRows[int(2 * pair + side)]];
                to[next[index]] = pair;
                next[index]++;
            }
        }

        // Finds by list index where the pairs begin whose rows on a side have it.
        private function findStarts(side:int):void
        {
            // the edges of the world have the last index
            var indexCount:int = listed.listIndices[ListedAgents.EDGES_ROW] + 1;
            makeRoom(_next, indexCount);
            var next:Vector.<int> = _next;
            for (var index:int = 0; index < indexCount; index++)
            {
                next[index] = 0;
            }
            var pairRows:Vector.<int> = rows;
            var indices:Vector.<int> = listed.listIndices;
            var end:int = 2 * count;
            for (var i:int = side; i < end; i += 2)
            {
                next[indices[pairRows[i]]]++;
            }
            var start:int = 0;
            for (index = 0; index < indexCount; index++)
            {
                var ofIndex:int = next[index];
                next[index] = start;
                start += ofIndex;
            }
        }

        // Puts the pairs into another order. @param order by the new index: the present one
        private function reorder(order:Vector.<int>):void
        {
            makeRoom(_backRows, 2 * count);
            makeRoom(_backTouchIndices, count);
            for (var i:int = 0; i < count; i++)
            {
                write(i, rows[int(2 * order[i])], rows[int(2 * order[i] + 1)], NO_TOUCH);
            }
            swapBuffers();
        }

        // Writes a pair of two rows to the back buffers.
        private function write(to:int, a:int, b:int, touchIndex:int):void
        {
            _backRows[int(2 * to)] = a;
            _backRows[int(2 * to + 1)] = b;
            _backTouchIndices[to] = touchIndex;
        }

        // Whether a pair comes before a pair of two rows in the order of the list.
        private function isBefore(pair:int, a:int, b:int):Boolean
        {
            var listIndices:Vector.<int> = listed.listIndices;
            var index:int = listIndices[rows[int(2 * pair)]];
            return index < listIndices[a] || index == listIndices[a] && listIndices[rows[int(2 * pair + 1)]] < listIndices[b];
        }

        // Swaps the lists of the pairs and their back buffers.
        private function swapBuffers():void
        {
            var rowsBefore:Vector.<int> = rows;
            rows = _backRows;
            _backRows = rowsBefore;
            var touchesBefore:Vector.<int> = touchIndices;
            touchIndices = _backTouchIndices;
            _backTouchIndices = touchesBefore;
        }

        /** Adds a pair of two rows without a touch. */
        internal function add(a:int, b:int):void
        {
            touchIndices[count] = NO_TOUCH;
            rows[2 * count] = a;
            rows[2 * count + 1] = b;
            count++;
        }

        /** Sets the time of a pair that <code>addPairs()</code> will add next. @param index among these pairs @param motion has the time */
        internal function setTime(index:int, motion:RelativeMotion):void
        {
            _times[int(count + index)] = motion.time;
        }

        /**
         * Adds the pairs of a row. In each of them the agent that is first in the list comes first. Their touches are not written before
         * <code>reorder()</code>.
         *
         * @param others begins with the rows that touch the row
         * @param othersCount the number of these
         */
        internal function addPairs(row:int, others:Vector.<int>, othersCount:int):void
        {
            var to:int = 2 * count;
            var listIndices:Vector.<int> = listed.listIndices;
            var index:int = listIndices[row];
            for (var i:int = 0; i < othersCount; i++)
            {
                // all bits of swaps are set if the other is first. Half of them are, so a branch would be mispredicted
                var swaps:int = (listIndices[others[i]] - index) >> 31;
                var change:int = (row ^ others[i]) & swaps;
                rows[to] = row ^ change;
                rows[int(to + 1)] = others[i] ^ change;
                to += 2;
            }
            count += othersCount;
        }

        /** The first agent of a pair. */
        public function firstOf(pair:int):Agent
        {
            return listed.agentsByRow[rows[2 * pair]];
        }

        /** The second agent of a pair. */
        public function secondOf(pair:int):Agent
        {
            return listed.agentsByRow[rows[2 * pair + 1]];
        }

        /** Writes the pairs as agents: a0, b0, a1, b1, ... */
        public function copyAgentsTo(out:Vector.<Agent>):void
        {
            var byRow:Vector.<Agent> = listed.agentsByRow;
            for (var i:int = 0; i < 2 * count; i++)
            {
                out[i] = byRow[rows[i]];
            }
        }
    }
}
