package starlogo.search
{
    import starlogo.broadphase.CellLists;
    import starlogo.data.IntList;
    import starlogo.engine;
    import starlogo.search.table.AgentTable;
    import starlogo.search.table.ListedAgents;

    use namespace engine;

    /**
     * Finds the pairs of a search from those of the last one, if few rows have changed since. It drops the pairs of rows that have changed, finds
     * the pairs that these rows have now, and puts them between the others. The pairs and their order are the same as in a search of all rows.
     *
     * <p>A row has changed if its agent has (<code>Agent.revision</code>), if its shape was replaced, if it came, left or got another place among the
     * others in the list, or if it becomes a member of the search or ceases to be one. After a search with sweeping agents, rows that moved in that
     * search have changed too, because their pairs belong to their motions.</p>
     *
     * <p>The test of a pair must give the same answer in either order of the two, because the row that has changed comes first here.</p>
     */
    internal final class KeptPairs
    {
        // Pairs are kept if there are at least this many rows for each row that has changed. The second number is for searches that are faster,
        // because all shapes are spheres, or only some breeds have handlers.
        private static const ROWS_PER_CHANGE:int = 8;
        private static const ROWS_PER_CHANGE_IF_FAST:int = 20;

        private var _table:AgentTable;
        private var _finder:PairFinder;
        private var _motions:RowMotions;

        // The pairs of the search, and whether they and the cells belong to the last one.
        private var _pairs:FoundPairs;
        private var _areValid:Boolean = false;

        // The pairs of changed rows that this search finds.
        private var _found:FoundPairs;

        // The members of the last search.
        private var _cells:CellLists;

        // What the pairs of the last search depended on besides agents, ground and edges: which pairs of breeds counted, to which a Collision adds none
        // later; whether an agent swept; whether a filter was asked; how deep trees were tested, or 0 for exactly.
        private var _interests:BreedInterests = null;
        private var _anySwept:Boolean = false;
        private var _isFiltered:Boolean = false;
        private var _maxDepth:int = 0;

        // By row: the mark of the last search that has found it changed. The mark of this search, and the rows that have it.
        private var _marks:Vector.<int> = new Vector.<int>();
        private var _mark:int = 0;
        private var _changed:IntList = new IntList();

        /**
         * @param table has the rows
         * @param finder finds the pairs of changed rows
         * @param motions of the rows, if an agent sweeps
         * @param pairs has the pairs of the last search, and gets those of the next one
         */
        public function KeptPairs(table:AgentTable, finder:PairFinder, motions:RowMotions, pairs:FoundPairs)
        {
            _table = table;
            _finder = finder;
            _motions = motions;
            _cells = new CellLists(table.places.levels);
            _pairs = pairs;
            _found = new FoundPairs(table.list);
        }

        /** The number of members of the search whose pairs are kept. */
        public function get memberCount():int
        {
            return _cells.count;
        }

        /** Lets the next search be one of all rows. */
        public function forget():void
        {
            _areValid = false;
        }

        /**
         * Finds the pairs of a search. The table has been read. Returns false if all rows have to be searched: because the search does not depend on
         * the same as the last one, no pairs are kept, too many rows have changed, or the cells need other buckets.
         */
        public function find(input:FrameInput):Boolean
        {
            if (!_areValid || !isLikeLast(input))
            {
                return false;
            }
            // they are not if the search throws
            _areValid = false;
            findChanged(input);
            if (!areFew(_changed.count))
            {
                return false;
            }
            if (_motions.areNeeded)
            {
                _motions.findMotions(_changed);
            }
            if (!updateCells(input) || !_cells.haveRightBucketCounts())
            {
                return false;
            }
            findPairsOfChanged(input);
            _pairs.drop(_marks, _mark);
            // the pairs that are kept touch at the end of their motions
            _pairs.merge(_found, _finder.earlyPairs);
            _areValid = true;
            return true;
        }

        /**
         * Keeps the pairs of a search of all rows, for which <code>find()</code> has returned false. If it was like the last one, the next search is
         * probably like it too. Otherwise its pairs are not worth keeping, and it only notes what the search depended on.
         *
         * @param members the members of the search
         */
        public function keep(members:IntList, input:FrameInput):void
        {
            if (isLikeLast(input))
            {
                _cells.begin(_motions.areNeeded ? _motions.extents : _table.extents, members, _table.list.agents.length);
                _areValid = true;
                return;
            }
            _interests = input.interests;
            _anySwept = _motions.areNeeded;
            _isFiltered = input.admitted != null;
            _maxDepth = currentDepth;
        }

        // Whether a search depends on the same as the last one, and few rows were read again.
        private function isLikeLast(input:FrameInput):Boolean
        {
            return _interests === input.interests && _anySwept == _motions.areNeeded && _isFiltered == (input.admitted != null)
                && _maxDepth == currentDepth && areFew(countRead());
        }

        private function get currentDepth():int
        {
            var limits:TreeLimits = _table.narrowPhase.treeLimits;
            return limits.exact ? 0 : limits.maxDepth;
        }

        // The number of rows that were read again, or have another place in the list.
        private function countRead():int
        {
            var count:int = _table.places.changed.count + _table.list.leftOrReordered.count;
            if (_motions.areNeeded)
            {
                count += _table.places.previouslyChanged.count;
            }
            return count;
        }

        // Whether so few rows have changed that a search of all rows would take longer.
        private function areFew(changes:int):Boolean
        {
            var rowsPerChange:int = _table.narrowPhase.choice.areSpheres || !_interests.includesAllOfAgents ? ROWS_PER_CHANGE_IF_FAST : ROWS_PER_CHANGE;
            return rowsPerChange * changes <= _table.list.rows.count;
        }

        // Finds the rows that have changed, and marks them.
        private function findChanged(input:FrameInput):void
        {
            _mark++;
            _changed.count = 0;
            var length:int = _table.list.agents.length;
            if (_marks.length < length)
            {
                _marks.length = length;
            }
            _cells.makeRoom(length);
            addAll(_table.places.changed);
            addAll(_table.list.leftOrReordered);
            if (_motions.areNeeded)
            {
                addAll(_table.places.previouslyChanged);
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
                _changed.add(row);
            }
        }

        // Adds the rows that become members, or cease to be members. The other rows have their breeds of the last search.
        private function addFiltered(input:FrameInput):void
        {
            var rows:IntList = _table.list.rows;
            for (var i:int = 0; i < rows.count; i++)
            {
                var row:int = rows.numbers[i];
                if (input.isMember(_table, row) != _cells.has(row))
                {
                    addChanged(row);
                }
            }
        }

        // Moves the changed rows to their cells. Returns false if one of them needs a level without buckets.
        private function updateCells(input:FrameInput):Boolean
        {
            for (var i:int = 0; i < _changed.count; i++)
            {
                var row:int = _changed.numbers[i];
                if (!input.isMember(_table, row))
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

        // Finds the pairs of the changed rows.
        private function findPairsOfChanged(input:FrameInput):void
        {
            _finder.begin(input, _found);
            for (var i:int = 0; i < _changed.count; i++)
            {
                if (_cells.has(_changed.numbers[i]))
                {
                    _cells.findNear(_changed.numbers[i], _marks, _mark, _finder);
                }
            }
            findPairsOfWorldAgent(ListedAgents.GROUND_ROW);
            findPairsOfWorldAgent(ListedAgents.EDGES_ROW);
            _finder.end();
        }

        // The pairs of changed rows with the ground or the edges; of all rows, if the ground or the edges have changed themselves.
        private function findPairsOfWorldAgent(worldRow:int):void
        {
            var hasChanged:Boolean = _table.hasWorldChanged[worldRow];
            if (hasChanged)
            {
                _marks[worldRow] = _mark;
            }
            _finder.findPairsOfWorldAgent(worldRow, hasChanged ? _table.list.rows : _changed);
        }
    }
}
