package starlogo.search
{
    import starlogo.broadphase.Bins;
    import starlogo.broadphase.CellLists;
    import starlogo.broadphase.Extents;
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
        private var _bins:Bins;
        private var _motions:SweptPairs;
        private var _narrowPhase:NarrowPhase;

        // The pairs, and whether they are those of the last search.
        private var _pairs:OrderedPairs;
        private var _isValid:Boolean = false;
        private var _wasValid:Boolean = false;

        // The members of the last search.
        private var _cells:CellLists;

        // What the pairs depend on besides the rows: the interests and other settings; the ground and the edges.
        private var _interests:BreedInterests = null;
        private var _settings:Vector.<int> = new Vector.<int>(6, true);
        private var _fixtures:Vector.<Object> = new <Object>[null, null];
        private var _fixtureStates:Vector.<Object> = new <Object>[null, null];
        private var _groundRevision:int = 0;

        // Whether breeds matter, an agent sweeps, and the filter's answers; the filter had a say in the last search.
        private var _areBreedsRead:Boolean = false;
        private var _isSwept:Boolean = false;
        private var _takePart:Vector.<Boolean> = null;
        private var _wasFiltered:Boolean = false;

        // The number of the search. By row: the last search that found the row changed. The rows that this one has found changed.
        private var _number:int = 0;
        private var _changedIn:Vector.<int> = new Vector.<int>();
        private var _changed:Vector.<int> = new Vector.<int>();
        private var _changedCount:int = 0;

        // The rows that are tested with the ground or the edges.
        private var _members:Vector.<int> = new Vector.<int>();

        /**
         * @param search makes the tests
         * @param bins give the members their cells
         * @param motions of the rows
         * @param narrowPhase has the settings of the tests
         */
        public function KeptPairs(search:CollisionSearch, bins:Bins, motions:SweptPairs, narrowPhase:NarrowPhase)
        {
            _search = search;
            _table = search.table;
            _bins = bins;
            _motions = motions;
            _narrowPhase = narrowPhase;
            _cells = new CellLists(bins.levels);
            _pairs = new OrderedPairs(_table, _cells);
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
         * @param takePart as in <code>CollisionSearch.find()</code>
         * @return whether the search is like the last one, and few rows have changed. Then call <code>find()</code>
         */
        public function begin(interests:BreedInterests, areBreedsRead:Boolean, isSwept:Boolean, takePart:Vector.<Boolean>):Boolean
        {
            _wasValid = _isValid;
            _isValid = false;
            _areBreedsRead = areBreedsRead;
            _isSwept = isSwept;
            _takePart = takePart;
            var isSame:Boolean = interests === _interests;
            _interests = interests;
            var trees:TreePairTests = _narrowPhase.trees;
            var maxDepth:int = trees == null ? 0 : trees.maxDepth;
            isSame = isStill(0, interests.revision) && isSame;
            isSame = isStill(1, areBreedsRead ? 1 : 0) && isSame;
            isSame = isStill(2, isSwept ? 1 : 0) && isSame;
            isSame = isStill(3, maxDepth) && isSame;
            isSame = isStill(4, trees != null && trees.exact ? 1 : 0) && isSame;
            isSame = isStill(5, trees != null && trees.byLeaves ? 1 : 0) && isSame;
            var among:int = _search.areSpheres || !interests.areAll ? OF_FAST : OF_ALL;
            var changes:int = _table.movedCount + _table.departedCount;
            if (isSwept)
            {
                changes += _table.movedBeforeCount;
            }
            return isSame && among * changes <= _table.count;
        }

        /** Takes the pairs of a search of all rows. */
        public function keep(out:FoundPairs, members:Vector.<int>, memberCount:int):void
        {
            var length:int = _table.agents.length;
            _cells.begin(extents, members, memberCount, length);
            _pairs.read(out, _isSwept ? _search.times : null);
            hasFixtureChanged(RowList.GROUND);
            hasFixtureChanged(RowList.EDGES);
            _wasFiltered = _takePart != null;
            _isValid = true;
        }

        /**
         * Finds the pairs.
         *
         * @param out takes them
         * @return false if the search has to be one of all rows. It is not touched then
         */
        public function find(out:FoundPairs):Boolean
        {
            if (!_wasValid)
            {
                return false;
            }
            _number++;
            _bins.pairCount = 0;
            listChanged();
            if (_isSwept)
            {
                _motions.find(_table, _bins, _changed, _changedCount);
            }
            placeChanged();
            if (!_cells.areCellsValid())
            {
                return false;
            }
            for (var i:int = 0; i < _changedCount; i++)
            {
                if (_cells.has(_changed[i]))
                {
                    findNear(_changed[i]);
                }
            }
            findAtFixture(RowList.GROUND);
            findAtFixture(RowList.EDGES);
            _pairs.renew(_changedIn, _number, _isSwept ? _search.times : null, out);
            _wasFiltered = _takePart != null;
            _isValid = true;
            return true;
        }

        private function get extents():Extents
        {
            return _isSwept ? _motions.extents : _table.extents;
        }

        private function isStill(setting:int, value:int):Boolean
        {
            var before:int = _settings[setting];
            _settings[setting] = value;
            return before == value;
        }

        private function hasFixtureChanged(row:int):Boolean
        {
            var agent:WorldAgent = _table.agents[row] as WorldAgent;
            var state:Object = null;
            var revision:int = _groundRevision;
            if (agent != null && row == RowList.GROUND)
            {
                state = agent.grid;
                revision = agent.grid.revision;
            }
            else if (agent != null)
            {
                state = agent.edges;
            }
            var isSame:Boolean = agent === _fixtures[row] && state === _fixtureStates[row] && revision == _groundRevision;
            _fixtures[row] = agent;
            _fixtureStates[row] = state;
            _groundRevision = revision;
            return !isSame;
        }

        // Lists the rows that have changed.
        private function listChanged():void
        {
            var length:int = _table.agents.length;
            _changedCount = 0;
            if (_changedIn.length < length)
            {
                _changedIn.length = length;
            }
            _cells.makeRows(length);
            mark(_table.moved, _table.movedCount);
            mark(_table.departed, _table.departedCount);
            if (_isSwept)
            {
                mark(_table.movedBefore, _table.movedBeforeCount);
            }
            if (_takePart != null || _wasFiltered)
            {
                markFiltered();
            }
        }

        private function mark(rows:Vector.<int>, count:int):void
        {
            for (var i:int = 0; i < count; i++)
            {
                markRow(rows[i]);
            }
        }

        private function markRow(row:int):void
        {
            if (_changedIn[row] != _number)
            {
                _changedIn[row] = _number;
                _changed[_changedCount] = row;
                _changedCount++;
            }
        }

        // Marks the rows that begin or cease to take part. The other rows have their breeds of the last search.
        private function markFiltered():void
        {
            var rows:Vector.<int> = _table.rows;
            for (var i:int = 0; i < _table.count; i++)
            {
                if (isMember(rows[i]) != _cells.has(rows[i]))
                {
                    markRow(rows[i]);
                }
            }
        }

        private function isMember(row:int):Boolean
        {
            return _table.shapes[row] != null && (!_areBreedsRead || _search.breeds[row] >= 0) && (_takePart == null || _takePart[_table.ranks[row]]);
        }

        // Puts the changed rows to their cells.
        private function placeChanged():void
        {
            var breeds:Vector.<int> = _search.breeds;
            if (_areBreedsRead && breeds.length < _table.agents.length)
            {
                breeds.length = _table.agents.length;
            }
            for (var i:int = 0; i < _changedCount; i++)
            {
                var row:int = _changed[i];
                var isListed:Boolean = _table.agents[row] != null;
                if (_areBreedsRead && isListed)
                {
                    breeds[row] = _interests.indexOfNumber(_table.agents[row].breedNumber);
                }
                if (isListed && isMember(row))
                {
                    _cells.put(row);
                }
                else
                {
                    _cells.remove(row);
                }
            }
        }

        private function findNear(row:int):void
        {
            for (var level:int = 0; level < _cells.levelCount; level++)
            {
                var count:int = _cells.findNear(row, level, _changedIn, _number);
                if (count > 0)
                {
                    _pairs.add(row, _cells.near, _search.numbers, _search.keepNear(row, _cells.near, count, _cells.slack, _pairs.foundCount));
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
            if (!_areBreedsRead)
            {
                return;
            }
            _search.breeds[fixture] = _fixtures[fixture] == null ? -1 : _interests.indexOfNumber(_table.agents[fixture].breedNumber);
            if (!_search.hasFixture(fixture))
            {
                return;
            }
            var rows:Vector.<int> = hasChanged ? _table.rows : _changed;
            var end:int = hasChanged ? _table.count : _changedCount;
            var count:int = 0;
            for (var i:int = 0; i < end; i++)
            {
                if (_cells.has(rows[i]))
                {
                    _members[count] = rows[i];
                    count++;
                }
            }
            _pairs.add(fixture, _members, _search.numbers, _search.keepAtFixture(_interests, fixture, _members, count, _pairs.foundCount));
        }

    }
}
