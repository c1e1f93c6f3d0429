package starlogo.search
{
    import starlogo.broadphase.BinLevel;
    import starlogo.broadphase.Bins;
    import starlogo.broadphase.Extents;
    import starlogo.broadphase.PairSink;
    import starlogo.data.IntList;
    import starlogo.data.IntSet;
    import starlogo.engine;
    import starlogo.search.table.AgentTable;

    use namespace engine;

    /**
     * The rows that have changed since the last search, and the members near them. Only these rows can have other pairs than in the last search.
     *
     * <p>A row has changed if its agent has (<code>Agent.revision</code>), if its shape was replaced, if it came, left or got another place among the
     * others in the list, or if it becomes a member of the search or ceases to be one. After a search with sweeping agents, rows that moved in that
     * search have changed too, because their pairs belong to their motions.</p>
     */
    internal final class ChangedRows extends PairSink
    {
        // Changed rows are few if there are at least this many rows for each of them.
        private static const ROWS_PER_CHANGE:int = 8;

        /** The rows of agents that have changed. Read only. */
        public var rows:IntList = new IntList();

        /** The rows whose pairs are found anew: the same, and those of the ground and the edges of the world if these have changed. Read only. */
        public var invalidRows:IntSet = new IntSet();

        /** The number of members of the search. Read only. */
        public var memberCount:int = 0;

        private var _table:AgentTable;
        private var _motions:RowMotions;

        // They have sorted all members, in this search or in an earlier one.
        private var _bins:Bins;

        // Takes the pairs.
        private var _candidateTests:CandidateTests;

        // The rows of the members.
        private var _members:IntSet = new IntSet();

        // The rows that have changed since the bins sorted all members, as a list and as a set. Other bins sort the members among them in each search.
        private var _staleRows:IntList = new IntList();
        private var _isStale:IntSet = new IntSet();
        private var _binsOfStaleRows:Bins = new Bins();

        /**
         * @param table has the rows
         * @param motions those of the rows
         * @param bins those of the searches of all rows
         * @param candidateTests takes the pairs
         */
        public function ChangedRows(table:AgentTable, motions:RowMotions, bins:Bins, candidateTests:CandidateTests)
        {
            _table = table;
            _motions = motions;
            _bins = bins;
            _candidateTests = candidateTests;
        }

        /** Begins with the members of a search of all rows, which the bins have sorted. */
        public function begin(members:IntList):void
        {
            memberCount = members.count;
            _members.clear(_table.listed.rowCapacity);
            for (var i:int = 0; i < members.count; i++)
            {
                _members.add(members.values[i]);
            }
            forgetStale();
        }

        private function forgetStale():void
        {
            _staleRows.count = 0;
            _isStale.clear(_table.listed.rowCapacity);
        }

        /**
         * Finds the rows that have changed. The table has read the agents, the ground and the edges.
         *
         * @return false if too many have changed, so that all rows have to be searched
         */
        public function tryFind(input:SearchInput):Boolean
        {
            if (!areFew(_table.changed.count + _table.listed.leftOrReordered.count + _motions.rowsToRetest.count))
            {
                return false;
            }
            findRows(input);
            return areFew(rows.count);
        }

        // Whether so few rows have changed that a search of these is faster than a search of all.
        private function areFew(changes:int):Boolean
        {
            return ROWS_PER_CHANGE * changes <= _table.listed.rows.count;
        }

        private function findRows(input:SearchInput):void
        {
            rows.count = 0;
            invalidRows.clear(_table.listed.rowCapacity);
            _members.grow(_table.listed.rowCapacity);
            _isStale.grow(_table.listed.rowCapacity);
            addAll(_table.changed);
            addAll(_table.listed.leftOrReordered);
            addAll(_motions.rowsToRetest);
            if (input.admitted != null)
            {
                addJoinedOrLeft(input);
            }
            // the ground and the edges are no members, but their pairs change with them
            for (var i:int = 0; i < _table.changedEnvironment.count; i++)
            {
                invalidRows.add(_table.changedEnvironment.values[i]);
            }
        }

        /** Finds the members near the changed ones, and passes each pair to the tests once. */
        public function findPairs(input:SearchInput):void
        {
            if (rows.count == 0)
            {
                return;
            }
            var extents:Extents = _motions.searchExtents;
            _motions.findExtents(rows);
            updateMembers(input);
            noteStale(input);
            var members:IntList = input.membersAmong(rows, _table);
            for (var i:int = 0; i < members.count; i++)
            {
                _bins.findNear(members.values[i], extents, _isStale, _candidateTests);
            }
            _binsOfStaleRows.findPairs(extents, input.membersAmong(_staleRows, _table), this);
        }

        /** Takes pairs of stale rows, and passes on those of which one has changed. @inheritDoc */
        override public function onCandidates(row:int, others:Vector.<int>, count:int, level:BinLevel):void
        {
            if (!invalidRows.has(row))
            {
                count = keepChanged(others, count);
            }
            if (count > 0)
            {
                _candidateTests.onCandidates(row, others, count, level);
            }
        }

        private function keepChanged(others:Vector.<int>, count:int):int
        {
            var kept:int = 0;
            for (var i:int = 0; i < count; i++)
            {
                if (invalidRows.has(others[i]))
                {
                    others[kept] = others[i];
                    kept++;
                }
            }
            return kept;
        }

        private function updateMembers(input:SearchInput):void
        {
            for (var i:int = 0; i < rows.count; i++)
            {
                var row:int = rows.values[i];
                var isMember:Boolean = input.isMember(row, _table);
                memberCount += int(isMember) - int(_members.has(row));
                _members.put(row, isMember);
            }
        }

        // Adds the changed rows to the stale ones. If these are too many, sorts all members anew, so that no other rows are stale.
        private function noteStale(input:SearchInput):void
        {
            addStale();
            if (!areFew(_staleRows.count))
            {
                _bins.sortIntoCells(_motions.searchExtents, input.membersOf(_table));
                forgetStale();
                addStale();
            }
        }

        private function addStale():void
        {
            for (var i:int = 0; i < rows.count; i++)
            {
                if (_isStale.add(rows.values[i]))
                {
                    _staleRows.add(rows.values[i]);
                }
            }
        }

        /** The rows whose pairs with the ground or the edges may have changed: all rows if the ground or the edges have. */
        public function rowsToTestWith(environmentRow:int):IntList
        {
            return invalidRows.has(environmentRow) ? _table.listed.rows : rows;
        }

        private function addAll(added:IntList):void
        {
            for (var i:int = 0; i < added.count; i++)
            {
                add(added.values[i]);
            }
        }

        private function add(row:int):void
        {
            if (invalidRows.add(row))
            {
                rows.add(row);
            }
        }

        // Adds the rows that become members, or cease to be members. The other rows have their breeds of the last search.
        private function addJoinedOrLeft(input:SearchInput):void
        {
            var listed:IntList = _table.listed.rows;
            for (var i:int = 0; i < listed.count; i++)
            {
                var row:int = listed.values[i];
                if (input.isMember(row, _table) != _members.has(row))
                {
                    add(row);
                }
            }
        }
    }
}
