package starlogo.search
{
    import starlogo.broadphase.Bins;
    import starlogo.broadphase.CellLists;
    import starlogo.data.NumberList;
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
        /** An answer of <code>find()</code>: it has found the pairs. */
        internal static const FOUND:int = 0;

        /** An answer: all rows have to be searched. This search is like the last one, so the next one probably is too, and its pairs should be kept. */
        internal static const SEARCH_AND_KEEP:int = 1;

        /** An answer: all rows have to be searched. The search is not like the last one, or many rows have changed. */
        internal static const SEARCH:int = 2;

        // Pairs are kept if at most one row in this many has changed. The second number is for searches that are faster, because all shapes are
        // spheres, or only some breeds have handlers.
        private static const ONE_IN:int = 8;
        private static const ONE_IN_IF_FAST:int = 20;

        private var _table:AgentTable;
        private var _candidates:CandidateFilter;
        private var _motions:RowMotions;

        // The pairs of the search, and whether they and the cells belong to the last one.
        private var _pairs:FoundPairs;
        private var _areValid:Boolean = false;

        // The pairs of changed rows that this search finds.
        private var _found:FoundPairs = new FoundPairs();

        // The members of the last search.
        private var _cells:CellLists;

        // What the pairs of the last search depended on besides agents, ground and edges: which pairs of breeds counted, and how often one was added
        // to them; whether an agent swept; whether a filter was asked; how deep trees were tested, or 0 for exactly.
        private var _interests:BreedInterests = null;
        private var _interestsRevision:int = 0;
        private var _anySweeps:Boolean = false;
        private var _isFiltered:Boolean = false;
        private var _maxDepth:int = 0;

        // The number of the search. By row: the last search that found the row changed. The rows that this one has found changed.
        private var _searchNumber:int = 0;
        private var _changedIn:Vector.<int> = new Vector.<int>();
        private var _changed:NumberList = new NumberList();

        /**
         * @param table has the rows
         * @param candidates finds the pairs among candidates
         * @param motions of the rows, if an agent sweeps
         * @param bins that a search of all rows uses
         * @param pairs has the pairs of the last search, and gets those of the next one
         */
        public function KeptPairs(table:AgentTable, candidates:CandidateFilter, motions:RowMotions, bins:Bins, pairs:FoundPairs)
        {
            _pairs = pairs;
            _table = table;
            _candidates = candidates;
            _motions = motions;
            _cells = new CellLists(bins);
        }

        /** The number of members. */
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
         * Keeps the pairs of a search of all rows for the next search.
         *
         * @param members the members of the search
         */
        public function keep(members:NumberList):void
        {
            _cells.begin(_anySweeps ? _motions.extents : _table.extents, members.numbers, members.count, _table.list.agents.length);
            _areValid = true;
        }

        /**
         * Finds the pairs of a search, if it is like the last one and few rows have changed. The table has been read.
         *
         * @param anySweeps whether an agent sweeps
         * @param limits how far trees are tested
         * @return FOUND, SEARCH_AND_KEEP or SEARCH
         */
        public function find(input:FrameInput, anySweeps:Boolean, limits:TreeLimits):int
        {
            var areValid:Boolean = _areValid;
            // they are not if the search throws
            _areValid = false;
            var isLikeLast:Boolean = hasConditionsOf(input, anySweeps, limits);
            takeConditions(input, anySweeps, limits);
            if (!isLikeLast || !areFew(countRead()))
            {
                return SEARCH;
            }
            if (!areValid)
            {
                return SEARCH_AND_KEEP;
            }
            _searchNumber++;
            listChanged(input);
            if (!areFew(_changed.count))
            {
                return SEARCH;
            }
            if (_anySweeps)
            {
                _motions.findMotions(_changed);
            }
            if (!placeChanged(input) || !_cells.areCellsValid())
            {
                return SEARCH_AND_KEEP;
            }
            findPairsOfChanged(input);
            _pairs.drop(_table.list, _changedIn, _searchNumber);
            _pairs.merge(_found, _anySweeps);
            _areValid = true;
            return FOUND;
        }

        // Whether the pairs of the last search depend on the same as those of this one. Then the same agents have the same pairs, if the same ones take
        // part.
        private function hasConditionsOf(input:FrameInput, anySweeps:Boolean, limits:TreeLimits):Boolean
        {
            return _interests === input.interests && _interestsRevision == revisionOf(input) && _anySweeps == anySweeps
                && _isFiltered == (input.takePart != null) && _maxDepth == depthOf(limits);
        }

        private function takeConditions(input:FrameInput, anySweeps:Boolean, limits:TreeLimits):void
        {
            _interests = input.interests;
            _interestsRevision = revisionOf(input);
            _anySweeps = anySweeps;
            _isFiltered = input.takePart != null;
            _maxDepth = depthOf(limits);
        }

        private static function revisionOf(input:FrameInput):int
        {
            return input.interests == null ? 0 : input.interests.revision;
        }

        private static function depthOf(limits:TreeLimits):int
        {
            return limits.exact ? 0 : limits.maxDepth;
        }

        // The number of rows that were read again, or have another place in the list.
        private function countRead():int
        {
            var count:int = _table.places.changed.count + _table.list.leftOrReordered.count;
            if (_anySweeps)
            {
                count += _table.places.previouslyChanged.count;
            }
            return count;
        }

        // Whether so few rows have changed that a search of all rows would take longer.
        private function areFew(changes:int):Boolean
        {
            var among:int = _table.areSpheres || _interests != null && !_interests.includesAllOfAgents ? ONE_IN_IF_FAST : ONE_IN;
            return among * changes <= _table.list.rows.count;
        }

        // Lists the rows that have changed.
        private function listChanged(input:FrameInput):void
        {
            var length:int = _table.list.agents.length;
            _changed.count = 0;
            if (_changedIn.length < length)
            {
                _changedIn.length = length;
            }
            _cells.makeRows(length);
            mark(_table.places.changed);
            mark(_table.list.leftOrReordered);
            if (_anySweeps)
            {
                mark(_table.places.previouslyChanged);
            }
            if (input.takePart != null)
            {
                markFiltered(input);
            }
        }

        private function mark(rows:NumberList):void
        {
            for (var i:int = 0; i < rows.count; i++)
            {
                markRow(rows.numbers[i]);
            }
        }

        private function markRow(row:int):void
        {
            if (_changedIn[row] != _searchNumber)
            {
                _changedIn[row] = _searchNumber;
                _changed.add(row);
            }
        }

        // Marks the rows that become members, or cease to be members. The other rows have their breeds of the last search.
        private function markFiltered(input:FrameInput):void
        {
            var rows:NumberList = _table.list.rows;
            for (var i:int = 0; i < rows.count; i++)
            {
                var row:int = rows.numbers[i];
                if (input.isMember(_table, row) != _cells.has(row))
                {
                    markRow(row);
                }
            }
        }

        // Puts the changed rows to their cells. Returns false if one of them needs a level without cells.
        private function placeChanged(input:FrameInput):Boolean
        {
            for (var i:int = 0; i < _changed.count; i++)
            {
                var row:int = _changed.numbers[i];
                if (_table.list.agents[row] == null || !input.isMember(_table, row))
                {
                    _cells.remove(row);
                }
                else if (!_cells.place(row))
                {
                    return false;
                }
            }
            return true;
        }

        // Finds the pairs of the changed rows.
        private function findPairsOfChanged(input:FrameInput):void
        {
            _candidates.begin(input, _anySweeps, _found);
            for (var i:int = 0; i < _changed.count; i++)
            {
                if (_cells.has(_changed.numbers[i]))
                {
                    _cells.findNear(_changed.numbers[i], _changedIn, _searchNumber, _candidates);
                }
            }
            findPairsOfWorldAgent(ListedAgents.GROUND_ROW);
            findPairsOfWorldAgent(ListedAgents.EDGES_ROW);
            _candidates.end();
        }

        // The pairs of changed rows with the ground or the edges; of all rows, if the ground or the edges have changed themselves.
        private function findPairsOfWorldAgent(worldRow:int):void
        {
            var hasChanged:Boolean = _table.hasWorldChanged[worldRow];
            if (hasChanged)
            {
                _changedIn[worldRow] = _searchNumber;
            }
            _candidates.findPairsOfWorldAgent(worldRow, hasChanged ? _table.list.rows : _changed);
        }
    }
}
