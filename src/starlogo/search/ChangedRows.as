package starlogo.search
{
    import starlogo.broadphase.BinLevel;
    import starlogo.broadphase.CellLists;
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
    internal final class ChangedRows
    {
        // Changed rows are few if there are at least this many rows for each of them.
        private static const ROWS_PER_CHANGE:int = 8;

        /** The rows of agents that have changed. Read only. */
        public var rows:IntList = new IntList();

        /** The rows whose pairs are found anew: the same, and those of the ground and the edges of the world if these have changed. Read only. */
        public var invalidRows:IntSet = new IntSet();

        private var _table:AgentTable;
        private var _motions:RowMotions;

        // The members of the last search of all rows. The first search of few rows after it puts them into cells, which then have the members of each
        // search. Games in which most rows change need no cells.
        private var _members:IntList = new IntList();
        private var _cells:CellLists;
        private var _hasCells:Boolean = false;

        /**
         * @param table has the rows
         * @param motions those of the rows
         * @param levels those of the bins
         */
        public function ChangedRows(table:AgentTable, motions:RowMotions, levels:Vector.<BinLevel>)
        {
            _table = table;
            _motions = motions;
            _cells = new CellLists(levels);
        }

        /** The number of members of the search. */
        public function get memberCount():int
        {
            return _cells.count;
        }

        /** Begins with the members of a search of all rows. */
        public function begin(members:IntList):void
        {
            _members.copyFrom(members);
            _hasCells = false;
        }

        /**
         * Finds the rows that have changed, and moves them to their cells. The table has read the agents, the ground and the edges.
         *
         * @return false if all rows have to be searched: if too many have changed, or the cells need other buckets
         */
        public function tryFind(input:SearchInput):Boolean
        {
            if (!areFew(_table.changed.count + _table.listed.leftOrReordered.count + _motions.rowsToRetest.count))
            {
                return false;
            }
            if (!_hasCells)
            {
                _cells.begin(_motions.searchExtents, _members, _table.listed.rowCapacity);
                _hasCells = true;
            }
            findRows(input);
            return areFew(rows.count) && tryMoveToCells(input);
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
            _cells.makeRoom(_table.listed.rowCapacity);
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

        // Moves the rows that have changed to their cells. Returns whether the cells have the right buckets, and each row a level with buckets.
        private function tryMoveToCells(input:SearchInput):Boolean
        {
            _motions.findExtents(rows);
            for (var i:int = 0; i < rows.count; i++)
            {
                var row:int = rows.values[i];
                if (!input.isMember(row, _table))
                {
                    _cells.remove(row);
                }
                else if (!_cells.tryUpdate(row))
                {
                    return false;
                }
            }
            return !_cells.needsNewBuckets;
        }

        /** Finds the members near the changed ones, as the bins do for all. Each pair is passed to the sink once. */
        public function findPairs(sink:PairSink):void
        {
            for (var i:int = 0; i < rows.count; i++)
            {
                if (_cells.has(rows.values[i]))
                {
                    _cells.findNear(rows.values[i], invalidRows, sink);
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
                if (input.isMember(row, _table) != _cells.has(row))
                {
                    add(row);
                }
            }
        }
    }
}
