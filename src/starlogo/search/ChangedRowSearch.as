package starlogo.search
{
    import starlogo.broadphase.BinLevel;
    import starlogo.broadphase.Bins;
    import starlogo.broadphase.Extents;
    import starlogo.broadphase.PairSink;
    import starlogo.data.IntList;
    import starlogo.data.ListedIntSet;
    import starlogo.engine;
    import starlogo.search.table.AgentTable;

    use namespace engine;

    /**
     * Finds the pairs of the rows that have changed since the last search. Only these rows can have other pairs than in the last search.
     *
     * <p>A row has changed if its agent has (<code>Agent.revision</code>), if its shape was replaced, if it came, left or got another place among the
     * others in the list, or if it becomes a member of the search or ceases to be one. After a search with sweeping agents, rows that moved in that
     * search have changed too, because their pairs belong to their motions.</p>
     */
    internal final class ChangedRowSearch extends PairSink
    {
        // Changed rows are few if there are at least this many rows for each of them.
        private static const ROWS_PER_CHANGE:int = 8;

        /** The rows that have changed. Those of the ground and the edges of the world come last. Read only. */
        public var changedRows:ListedIntSet = new ListedIntSet();

        /** The number of members of the search. Read only. */
        public var memberCount:int = 0;

        private var _table:AgentTable;
        private var _motions:RowMotions;

        // They have sorted all members, in this search or in an earlier one.
        private var _bins:Bins;

        // Takes the pairs.
        private var _candidateTests:CandidateTests;

        // By row: whether it is a member.
        private var _areMembers:Vector.<Boolean> = new Vector.<Boolean>();

        // The rows that have changed since the bins sorted all members. Other bins sort the members among them in each search.
        private var _staleRows:ListedIntSet = new ListedIntSet();
        private var _binsOfStaleRows:Bins = new Bins();

        /**
         * @param table has the rows
         * @param motions those of the rows
         * @param bins those of the searches of all rows
         * @param candidateTests takes the pairs
         */
        public function ChangedRowSearch(table:AgentTable, motions:RowMotions, bins:Bins, candidateTests:CandidateTests)
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
            for (var row:int = 0; row < _table.listed.rowCapacity; row++)
            {
                _areMembers[row] = false;
            }
            for (var i:int = 0; i < members.count; i++)
            {
                _areMembers[members.values[i]] = true;
            }
            _staleRows.clear(_table.listed.rowCapacity);
        }

        /**
         * Finds the rows that have changed. The table has read the agents, the ground and the edges.
         *
         * @return false if too many have changed, so that all rows have to be searched
         */
        public function tryFindRows(input:SearchInput):Boolean
        {
            if (!areFew(_table.changes.rows.count + _table.listed.leftOrReordered.count + _motions.rowsToRetest.count))
            {
                return false;
            }
            findRows(input);
            if (!areFew(changedRows.list.count))
            {
                return false;
            }
            changedRows.addAll(_table.environment.changed);
            return true;
        }

        // Whether so few rows have changed that a search of these is faster than a search of all.
        private function areFew(changes:int):Boolean
        {
            return ROWS_PER_CHANGE * changes <= _table.listed.rows.count;
        }

        private function findRows(input:SearchInput):void
        {
            changedRows.clear(_table.listed.rowCapacity);
            changedRows.addAll(_table.changes.rows);
            changedRows.addAll(_table.listed.leftOrReordered);
            changedRows.addAll(_motions.rowsToRetest);
            for (var row:int = _areMembers.length; row < _table.listed.rowCapacity; row++)
            {
                _areMembers[row] = false;
            }
            if (input.admitted != null)
            {
                addJoinedOrLeft(input);
            }
        }

        /** Finds the members near the changed ones, and passes each pair to the tests once. */
        public function findPairs(input:SearchInput):void
        {
            if (changedRows.list.count == 0)
            {
                return;
            }
            var extents:Extents = _motions.searchExtents;
            _motions.findExtents(changedRows.list);
            updateMembers(input);
            noteStale(input);
            var members:IntList = input.membersAmong(changedRows.list, _table);
            for (var i:int = 0; i < members.count; i++)
            {
                _bins.findNear(members.values[i], extents, _staleRows, _candidateTests);
            }
            _binsOfStaleRows.findPairs(extents, input.membersAmong(_staleRows.list, _table), this);
        }

        /** Takes pairs of stale rows, and passes on those of which one has changed. @inheritDoc */
        override public function onCandidates(row:int, others:Vector.<int>, count:int, level:BinLevel):void
        {
            if (!changedRows.has(row))
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
                if (changedRows.has(others[i]))
                {
                    others[kept] = others[i];
                    kept++;
                }
            }
            return kept;
        }

        private function updateMembers(input:SearchInput):void
        {
            for (var i:int = 0; i < changedRows.list.count; i++)
            {
                var row:int = changedRows.list.values[i];
                var isMember:Boolean = input.isMember(row, _table);
                memberCount += int(isMember) - int(_areMembers[row]);
                _areMembers[row] = isMember;
            }
        }

        // Adds the changed rows to the stale ones. If these are too many, sorts all members anew, so that no other rows are stale.
        private function noteStale(input:SearchInput):void
        {
            _staleRows.grow(_table.listed.rowCapacity);
            _staleRows.addAll(changedRows.list);
            if (!areFew(_staleRows.list.count))
            {
                _bins.sortIntoCells(_motions.searchExtents, input.membersOf(_table));
                _staleRows.clear(_table.listed.rowCapacity);
                _staleRows.addAll(changedRows.list);
            }
        }

        /** The rows whose pairs with the ground or the edges may have changed: all rows if the ground or the edges have. */
        public function rowsToTestWith(environmentRow:int):IntList
        {
            return changedRows.has(environmentRow) ? _table.listed.rows : changedRows.list;
        }

        // Adds the rows that become members, or cease to be members. The other rows have their breeds of the last search.
        private function addJoinedOrLeft(input:SearchInput):void
        {
            var listed:IntList = _table.listed.rows;
            for (var i:int = 0; i < listed.count; i++)
            {
                var row:int = listed.values[i];
                if (input.isMember(row, _table) != _areMembers[row])
                {
                    changedRows.add(row);
                }
            }
        }
    }
}
