package starlogo.search
{
    import starlogo.broadphase.BinLevel;
    import starlogo.broadphase.CellLists;
    import starlogo.broadphase.PairSink;
    import starlogo.data.IntList;
    import starlogo.engine;
    import starlogo.search.table.AgentTable;
    import starlogo.search.table.ListedAgents;

    use namespace engine;

    /**
     * The rows that have changed since the last search, if they are few, and the members near them. Only these rows can have other pairs than in the
     * last search.
     *
     * <p>A row has changed if its agent has (<code>Agent.revision</code>), if its shape was replaced, if it came, left or got another place among the
     * others in the list, or if it becomes a member of the search or ceases to be one. After a search with sweeping agents, rows that moved in that
     * search have changed too, because their pairs belong to their motions.</p>
     */
    internal final class ChangedRows
    {
        // Changed rows are few if there are at least this many rows for each of them. The second number is for searches that are faster,
        // because all shapes are spheres, or only some breeds have handlers.
        private static const ROWS_PER_CHANGE:int = 8;
        private static const ROWS_PER_CHANGE_IF_FAST:int = 20;

        private var _table:AgentTable;
        private var _narrowPhase:NarrowPhase;
        private var _motions:RowMotions;

        // The members of the last search.
        private var _cells:CellLists;

        // What the pairs of the last search depended on besides agents, ground and edges: which pairs of breeds counted, to which a Collision adds none
        // later; whether an agent swept; whether a filter was asked; how deep trees were tested, or 0 for exactly.
        private var _interests:BreedInterests = null;
        private var _wereSwept:Boolean = false;
        private var _isFiltered:Boolean = false;
        private var _maxDepth:int = 0;

        // By row: the mark of the last search that has found it changed. The mark of this search, and the rows that have it.
        private var _marks:Vector.<int> = new Vector.<int>();
        private var _mark:int = 0;
        private var _rows:IntList = new IntList();

        /**
         * @param table has the rows
         * @param narrowPhase has the settings of the tests
         * @param motions those of the rows
         * @param levels those of the bins
         */
        public function ChangedRows(table:AgentTable, narrowPhase:NarrowPhase, motions:RowMotions, levels:Vector.<BinLevel>)
        {
            _table = table;
            _narrowPhase = narrowPhase;
            _motions = motions;
            _cells = new CellLists(levels);
        }

        /** The number of members of the search. */
        public function get memberCount():int
        {
            return _cells.countMembers();
        }

        /**
         * Notes a search of all rows that has ended.
         *
         * @param members the members of the search
         * @return whether <code>moveChanged()</code> may be called for the next search: if this one was like the one before, the next is probably like it
         *     too. Otherwise it would hardly be worth it
         */
        public function noteSearch(members:IntList, input:FrameInput):Boolean
        {
            if (isLikeLast(input))
            {
                _cells.begin(_motions.areSwept ? _motions.extents : _table.extents, members, _table.list.agents.length);
                return true;
            }
            _interests = input.interests;
            _wereSwept = _motions.areSwept;
            _isFiltered = input.admitted != null;
            _maxDepth = currentDepth;
            return false;
        }

        /**
         * Finds the rows that have changed, and moves them to their cells. The table has read the agents, the ground and the edges.
         *
         * @return false if all rows have to be searched: because the search does not depend on the same as the last one, too many rows have changed,
         *     or the cells need other buckets
         */
        public function moveChanged(input:FrameInput):Boolean
        {
            if (!isLikeLast(input))
            {
                return false;
            }
            markChanged(input);
            if (!areFew(_rows.count))
            {
                return false;
            }
            if (_motions.areSwept)
            {
                _motions.begin(_rows);
            }
            return updateCells(input) && _cells.haveRightBucketCounts();
        }

        /** Finds the members near the changed ones, as the bins do for all. Each pair is passed to the sink once. */
        public function findPairs(sink:PairSink):void
        {
            for (var i:int = 0; i < _rows.count; i++)
            {
                if (_cells.has(_rows.numbers[i]))
                {
                    _cells.findNear(_rows.numbers[i], _marks, _mark, sink);
                }
            }
        }

        /** The rows whose pairs with the ground or the edges may have changed: all rows if the ground or the edges have. */
        public function rowsToTestWith(worldRow:int):IntList
        {
            return _marks[worldRow] == _mark ? _table.list.rows : _rows;
        }

        /**
         * Changes the pairs of the last search to those of this one.
         *
         * @param found the pairs of the changed rows, in order
         * @param earlyCount how many of these touch before the end of their motions
         */
        public function updatePairs(pairs:FoundPairs, found:FoundPairs, earlyCount:int):void
        {
            pairs.follow(_marks, _mark, found, earlyCount);
        }

        // Whether a search depends on the same as the last one, and few rows were read again.
        private function isLikeLast(input:FrameInput):Boolean
        {
            return _interests === input.interests && _wereSwept == _motions.areSwept && _isFiltered == (input.admitted != null)
                && _maxDepth == currentDepth && areFew(countRead());
        }

        private function get currentDepth():int
        {
            var limits:TreeLimits = _narrowPhase.treeLimits;
            return limits.exact ? 0 : limits.maxDepth;
        }

        // The number of rows that were read again, or have another place in the list.
        private function countRead():int
        {
            var count:int = _table.changed.count + _table.leftOrReordered.count;
            if (_motions.areSwept)
            {
                count += _motions.previouslyChanged.count;
            }
            return count;
        }

        // Whether so few rows have changed that a search of all rows would take longer.
        private function areFew(changes:int):Boolean
        {
            var rowsPerChange:int = _narrowPhase.choice.areSpheres || !_interests.includesAllOfAgents ? ROWS_PER_CHANGE_IF_FAST : ROWS_PER_CHANGE;
            return rowsPerChange * changes <= _table.list.rows.count;
        }

        // Finds the rows that have changed, and marks them.
        private function markChanged(input:FrameInput):void
        {
            _mark++;
            _rows.count = 0;
            var length:int = _table.list.agents.length;
            if (_marks.length < length)
            {
                _marks.length = length;
            }
            _cells.makeRoom(length);
            // the ground and the edges are no members, but their pairs change with them
            for (var i:int = 0; i < _table.changedOfWorld.count; i++)
            {
                _marks[_table.changedOfWorld.numbers[i]] = _mark;
            }
            addAll(_table.changed);
            addAll(_table.leftOrReordered);
            if (_motions.areSwept)
            {
                addAll(_motions.previouslyChanged);
            }
            if (input.admitted != null)
            {
                addFiltered(input);
            }
        }

        private function addAll(rows:IntList):void
        {
            for (var i:int = 0; i < rows.count; i++)
            {
                addChanged(rows.numbers[i]);
            }
        }

        private function addChanged(row:int):void
        {
            if (_marks[row] != _mark)
            {
                _marks[row] = _mark;
                _rows.add(row);
            }
        }

        // Adds the rows that become members, or cease to be members. The other rows have their breeds of the last search.
        private function addFiltered(input:FrameInput):void
        {
            var rows:IntList = _table.list.rows;
            for (var i:int = 0; i < rows.count; i++)
            {
                var row:int = rows.numbers[i];
                if (input.isMember(row, _table) != _cells.has(row))
                {
                    addChanged(row);
                }
            }
        }

        // Moves the changed rows to their cells. Returns false if one of them needs a level without buckets.
        private function updateCells(input:FrameInput):Boolean
        {
            for (var i:int = 0; i < _rows.count; i++)
            {
                var row:int = _rows.numbers[i];
                if (!input.isMember(row, _table))
                {
                    _cells.remove(row);
                }
                else if (!_cells.update(row))
                {
                    return false;
                }
            }
            return true;
        }
    }
}
