package starlogo.search
{
    import starlogo.broadphase.CellLists;
    import starlogo.engine;

    use namespace engine;

    /**
     * Finds the pairs of a search from those of the last one, if few rows have changed since. It drops the pairs of rows that have changed, finds
     * the pairs that these rows have now, and puts them between the others. The pairs and their order are the same as in a search of all rows.
     *
     * <p>A row has changed if its agent has (<code>Agent.revision</code>), if its shape was replaced, if it came, left or got another place among the
     * others in the list, or if it begins or ceases to take part. After a search with sweeping agents, rows that moved in that search have changed too,
     * because their pairs belong to their motions.</p>
     *
     * <p>The test of a pair must give the same answer in either order of the two, because the row that has changed comes first here.</p>
     */
    internal final class KeptPairs
    {
        // Pairs are kept if at most one row in OF_ALL has changed. If all shapes are spheres, or only some breeds have handlers, at most one row in
        // OF_FAST may have changed.
        private static const OF_ALL:int = 8;
        private static const OF_FAST:int = 20;

        private var _search:CollisionSearch;
        private var _table:AgentTable;

        // The pairs of the last search, and their number. They are kept unless somebody else has written other pairs there, or they are void.
        private var _pairs:FoundPairs = null;
        private var _pairsNumber:int = 0;
        private var _isValid:Boolean = false;

        // The pairs that this search finds.
        private var _found:FoundPairs = new FoundPairs();

        // The members of the last search.
        private var _cells:CellLists;

        // What the pairs depend on besides the rows: the interests and other settings; the ground and the edges; whether there was a filter.
        private var _interests:BreedInterests = null;
        private var _settings:Vector.<int> = new Vector.<int>(4, true);
        private var _fixtures:Vector.<WorldAgent> = new <WorldAgent>[null, null];
        private var _edges:Vector.<Number> = null;
        private var _groundRevision:int = 0;

        // The number of the search. By row: the last search that found the row changed. The rows that this one has found changed.
        private var _number:int = 0;
        private var _changedIn:Vector.<int> = new Vector.<int>();
        private var _changed:NumberList = new NumberList();

        /** @param search makes the tests */
        public function KeptPairs(search:CollisionSearch)
        {
            _search = search;
            _table = search.table;
            _cells = new CellLists(search.bins.levels);
        }

        /** The number of rows that take part. */
        public function get memberCount():int
        {
            return _cells.count;
        }

        /** Lets the next search be one of all rows. */
        public function forget():void
        {
            _isValid = false;
        }

        /**
         * Begins a search. The table has been read.
         *
         * @return whether the search is like the last one, and few rows have changed. Then call <code>find()</code>
         */
        public function begin(interests:BreedInterests):Boolean
        {
            var isSame:Boolean = interests === _interests;
            _interests = interests;
            var trees:TreePairTests = _search.narrowPhase.trees;
            isSame = isStill(0, interests.revision) && isSame;
            isSame = isStill(1, trees == null || trees.exact ? 0 : trees.maxDepth) && isSame;
            isSame = isStill(2, _search.isSwept ? 1 : 0) && isSame;
            isSame = isStill(3, _search.takePart == null ? 0 : 1) && isSame;
            var among:int = _search.areSpheres || !interests.areAll ? OF_FAST : OF_ALL;
            var changes:int = _table.places.moved.count + _table.list.departed.count;
            if (_search.isSwept)
            {
                changes += _table.places.movedBefore.count;
            }
            isSame = isSame && among * changes <= _table.list.count;
            _isValid = _isValid && isSame;
            return isSame;
        }

        /** Takes the pairs of a search of all rows. */
        public function keep(out:FoundPairs, members:Vector.<int>, memberCount:int):void
        {
            _cells.begin(_search.extents, members, memberCount, _table.list.agents.length);
            note(out);
            hasFixtureChanged(ListedAgents.GROUND);
            hasFixtureChanged(ListedAgents.EDGES);
        }

        /**
         * Finds the pairs.
         *
         * @param out has the pairs of the last search, and takes those of this one
         * @return false if the search has to be one of all rows. It is not touched then
         */
        public function find(out:FoundPairs):Boolean
        {
            if (!_isValid || out !== _pairs || out.number != _pairsNumber)
            {
                return false;
            }
            // they are not if the search throws
            _isValid = false;
            _number++;
            listChanged();
            if (_search.isSwept)
            {
                _search.motions.find(_table, _search.bins.levels, _changed.numbers, _changed.count);
            }
            placeChanged();
            if (!_cells.areCellsValid())
            {
                return false;
            }
            _search.writeTo(_found);
            for (var i:int = 0; i < _changed.count; i++)
            {
                if (_cells.has(_changed.numbers[i]))
                {
                    _cells.findNear(_changed.numbers[i], _changedIn, _number, _search);
                }
            }
            findAtFixture(ListedAgents.GROUND);
            findAtFixture(ListedAgents.EDGES);
            out.drop(_table.list, _changedIn, _number);
            out.merge(_found, _search.order.sort(_found, _search.isSwept));
            note(out);
            return true;
        }

        private function note(out:FoundPairs):void
        {
            _pairs = out;
            _pairsNumber = out.number;
            _isValid = true;
        }

        private function isStill(setting:int, value:int):Boolean
        {
            var before:int = _settings[setting];
            _settings[setting] = value;
            return before == value;
        }

        private function hasFixtureChanged(row:int):Boolean
        {
            var agent:WorldAgent = _table.list.agents[row] as WorldAgent;
            var isSame:Boolean = agent === _fixtures[row];
            _fixtures[row] = agent;
            if (agent != null && row == ListedAgents.GROUND)
            {
                isSame = agent.grid.revision == _groundRevision && isSame;
                _groundRevision = agent.grid.revision;
            }
            else if (agent != null)
            {
                isSame = agent.edges === _edges && isSame;
                _edges = agent.edges;
            }
            return !isSame;
        }

        // Lists the rows that have changed.
        private function listChanged():void
        {
            var length:int = _table.list.agents.length;
            _changed.count = 0;
            if (_changedIn.length < length)
            {
                _changedIn.length = length;
            }
            _cells.makeRows(length);
            mark(_table.places.moved);
            mark(_table.list.departed);
            if (_search.isSwept)
            {
                mark(_table.places.movedBefore);
            }
            if (_search.takePart != null)
            {
                markFiltered();
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
            if (_changedIn[row] != _number)
            {
                _changedIn[row] = _number;
                _changed.add(row);
            }
        }

        // Marks the rows that begin or cease to take part. The other rows have their breeds of the last search.
        private function markFiltered():void
        {
            var rows:Vector.<int> = _table.list.rows;
            for (var i:int = 0; i < _table.list.count; i++)
            {
                if (_search.isMember(rows[i]) != _cells.has(rows[i]))
                {
                    markRow(rows[i]);
                }
            }
        }

        // Puts the changed rows to their cells.
        private function placeChanged():void
        {
            for (var i:int = 0; i < _changed.count; i++)
            {
                var row:int = _changed.numbers[i];
                if (_table.list.agents[row] != null && _search.isMember(row))
                {
                    _cells.put(row);
                }
                else
                {
                    _cells.remove(row);
                }
            }
        }

        // The pairs of changed rows with the ground or the edges; of all rows, if the ground or the edges have changed themselves.
        private function findAtFixture(fixture:int):void
        {
            var hasChanged:Boolean = hasFixtureChanged(fixture);
            if (hasChanged)
            {
                _changedIn[fixture] = _number;
            }
            var rows:Vector.<int> = hasChanged ? _table.list.rows : _changed.numbers;
            _search.findAtFixture(fixture, rows, hasChanged ? _table.list.count : _changed.count);
        }
    }
}
