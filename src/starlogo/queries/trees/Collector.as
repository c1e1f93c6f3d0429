package starlogo.queries.trees
{
    import starlogo.agents.Agent;
    import starlogo.data.SortableIntList;
    import starlogo.engine;
    import starlogo.queries.AgentFilter;
    import starlogo.queries.SeenAgents;

    use namespace engine;

    /**
     * The answer of a question while it is searched for: the rows with the smallest keys, as many as are wanted. A key is a distance, a squared
     * distance or a time. Rows with the same key are in the order of the list.
     *
     * <p>A question takes one row after the other from a SweptBoxSearch, tests it, and adds it with its key. A NearSearch adds rows itself. The limit is
     * the largest key of a row that is still wanted. It shrinks when enough rows are found, so the search visits less. One of the methods that begin with
     * "end" makes the answer.</p>
     *
     * <p>Rows that a filter excludes are left out before they are tested. The filter's own function, <code>accepts</code>, is called
     * for rows that pass all tests, in the order of their keys, and no oftener than the answer needs. Motions and casts of shapes call it for all rows
     * near them. It may ask questions itself. These have Collectors of their own (NestedPool).</p>
     *
     * @private
     */
    public final class Collector
    {
        /** A value of <code>maxCount</code>: all rows. */
        public static const ALL:int = int.MAX_VALUE;

        /** The rows that the filter admits. Read only. */
        public var filter:RowFilter = new RowFilter();

        /** The largest key of a row that is still wanted. It is less than 0 if no more rows are wanted. Read only. */
        public var limit:Number = Infinity;

        /** How many rows are found at most, or ALL. Read only. */
        public var maxCount:int = ALL;

        private var _seen:SeenAgents;

        // The rows that were found, unsorted, and their keys. If accepts decides, the rows that it has admitted come first.
        private var _rows:SortableIntList = new SortableIntList();

        // When this number of rows is found, the rows that are not wanted are dropped.
        private var _trimCount:int = ALL;

        // The number of rows that accepts has admitted, in order.
        private var _admitted:int = 0;

        /** @param seen the agents that the question is about */
        public function Collector(seen:SeenAgents)
        {
            _seen = seen;
        }

        /**
         * Begins a search. Returns this collector.
         *
         * @param maxCount how many of the rows with the smallest keys count, or ALL
         * @param limit the largest key
         * @param asker the agent that asks, which is left out; or null
         * @param agentFilter the agents that count; null for all
         */
        public function begin(maxCount:int, limit:Number, asker:Agent, agentFilter:AgentFilter):Collector
        {
            filter.begin(_seen.table.listed, asker, agentFilter);
            this.maxCount = maxCount;
            this.limit = maxCount == 0 ? -1 : limit;
            _trimCount = filter.accepts == null ? maxCount : ALL;
            _rows.count = _admitted = 0;
            return this;
        }

        /** Whether a row has a shape and the filter may admit it. */
        public function mayWant(row:int):Boolean
        {
            return _seen.table.shapes[row] != null && filter.mayAdmit(row);
        }

        /** Adds a row that the question has found. This may lower the limit. */
        public function add(row:int, key:Number):void
        {
            _rows.add(row, key);
            if (_rows.count == _trimCount)
            {
                keepFirst();
                limit = _rows.keys[int(maxCount - 1)];
                // only then again, so that each row is sorted about twice
                _trimCount = maxCount > ALL / 2 ? ALL : 2 * maxCount;
            }
        }

        /** Whether enough rows are found for a question for which their keys do not matter. */
        public function get hasEnough():Boolean
        {
            return filter.accepts == null && _rows.count >= maxCount;
        }

        /**
         * Calls <code>accepts</code> for the rows whose keys are smaller than a bound, in the order of the keys, until enough are admitted. Rows
         * that are found later must have no smaller keys.
         */
        public function askAcceptsBelow(bound:Number):void
        {
            var end:int = bound < Infinity ? bringForward(bound) : _rows.count;
            if (end == _admitted)
            {
                return;
            }
            _rows.sortFirst(end, _seen.table.listed.listIndices);
            admitTo(end);
            if (_admitted == maxCount)
            {
                limit = -1;
            }
            // what was refused leaves
            var kept:int = _admitted;
            for (var i:int = end; i < _rows.count; i++)
            {
                move(i, kept);
                kept++;
            }
            _rows.count = kept;
        }

        // Brings the rows whose keys are smaller than a bound to the front, behind the admitted ones. Returns where they end.
        private function bringForward(bound:Number):int
        {
            var end:int = _admitted;
            for (var i:int = end; i < _rows.count; i++)
            {
                var key:Number = _rows.keys[i];
                if (key < bound)
                {
                    var row:int = _rows.values[i];
                    move(end, i);
                    _rows.values[end] = row;
                    _rows.keys[end] = key;
                    end++;
                }
            }
            return end;
        }

        // Calls accepts for the rows behind the admitted ones, up to an index, until enough are admitted. They come first then.
        private function admitTo(end:int):void
        {
            var decide:Function = filter.accepts;
            _seen.callbackDepth++;
            try
            {
                for (var i:int = _admitted; i < end && _admitted < maxCount; i++)
                {
                    if (decide(agentAt(i)))
                    {
                        move(i, _admitted);
                        _admitted++;
                    }
                }
            }
            finally
            {
                _seen.callbackDepth--;
            }
        }

        private function move(from:int, to:int):void
        {
            _rows.values[to] = _rows.values[from];
            _rows.keys[to] = _rows.keys[from];
        }

        /** Ends the search, and sorts the rows of the answer. Returns how many they are. */
        public function end():int
        {
            if (filter.accepts == null)
            {
                keepFirst();
            }
            else
            {
                askAcceptsBelow(Infinity);
            }
            return _rows.count;
        }

        // Sorts the rows, and keeps those that are wanted.
        private function keepFirst():void
        {
            _rows.sortFirst(_rows.count, _seen.table.listed.listIndices);
            _rows.count = Math.min(_rows.count, maxCount);
        }

        /** A row of the answer. */
        public function rowAt(index:int):int
        {
            return _rows.values[index];
        }

        // The agent of a row of the answer.
        private function agentAt(index:int):Agent
        {
            return _seen.table.listed.agentsByRow[rowAt(index)];
        }

        /** Ends a search for all rows. Returns how many they are, without sorting them. */
        public function endWithCount():int
        {
            return filter.accepts == null ? _rows.count : end();
        }

        /** Ends the search. Returns the agent of the first row of the answer, or null. */
        public function endWithFirst():Agent
        {
            return end() == 0 ? null : agentAt(0);
        }

        /**
         * Ends the search, and lists the agents of the answer.
         *
         * @param out receives the list; null for a new list
         * @return out, or the new list
         */
        public function endWithList(out:Vector.<Agent>):Vector.<Agent>
        {
            var listed:Vector.<Agent> = out || new Vector.<Agent>();
            var length:int = end();
            // one element at a time, because V8 frees an array's memory if its length is set to less
            while (listed.length > length)
            {
                listed.pop();
            }
            for (var i:int = 0; i < length; i++)
            {
                listed[i] = agentAt(i);
            }
            return listed;
        }
    }
}
