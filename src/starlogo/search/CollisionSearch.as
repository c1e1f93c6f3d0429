// This room finds the pairs of agents that touch, and how they touch. CollisionSearch shows the steps of a search:
// 1. AgentTable (table/) reads the agents into rows. If an agent sweeps, RowMotions reads their motions.
// 2. The Bins of the room broadphase find rows that are near each other. If few rows have changed since the last search, ChangedRowSearch finds these rows
// and the pairs of these.
// 3. CandidateTests keeps the pairs that touch, where they are or on their motions. The NarrowPhase has a PairTests for each kind of pairs (pairs/).
// 4. The FoundPairs are put into the order of the list. The pairs of changed rows are put between those of the last search.
// A Body is a shape (ModelShape) at a place. A BaseShapeChoice says which shape a model has, SearchInput who takes part, BreedInterests which breeds
// count.
// Read this file first, then AgentTable, CandidateTests and NarrowPhase. AgentContacts tells how two agents touch. Contacts get their depths from
// PenetrationSearch (penetration/).
package starlogo.search
{
    import flash.errors.IllegalOperationError;
    import starlogo.broadphase.Bins;
    import starlogo.data.IntList;
    import starlogo.engine;
    import starlogo.search.table.AgentTable;
    import starlogo.search.table.ListedAgents;

    use namespace engine;

    /**
     * Finds the pairs of agents that touch: the search that all colliders share. It reads the agents into a table. The bins find the pairs of
     * rows that are near each other (thesis §3.7). Of these it keeps those that touch and whose breeds are of interest, and puts them into order. If
     * few agents have changed, it takes the pairs of the others from the last search.
     *
     * @private
     */
    public final class CollisionSearch
    {
        /** The agents of the last search. */
        public var table:AgentTable;

        /** Tests their bodies. It may have other searches too. */
        public var narrowPhase:NarrowPhase;

        /** Whether and how two agents touch. It changes no place and no motion of the search. */
        public var contacts:AgentContacts;

        private var _bins:Bins = new Bins();
        private var _candidateTests:CandidateTests;
        private var _motions:RowMotions;
        private var _changedRowSearch:ChangedRowSearch;

        // The pairs of the search.
        private var _pairs:FoundPairs;

        // If few rows have changed: their pairs, which are put between the others.
        private var _pairsOfChanged:FoundPairs;

        // What the pairs depend on, besides agents, ground and edges: the pairs of breeds that count, their number, because a game that calls
        // findCollisionsAmong() may add some, how deep trees are tested, and whether there is a filter. The first is null if there are no pairs to update.
        private var _interests:BreedInterests = null;
        private var _interestCount:int = 0;
        private var _depth:int = 0;
        private var _isFiltered:Boolean = false;

        /** @param narrowPhase chooses the shapes of the agents, and tests their bodies */
        public function CollisionSearch(narrowPhase:NarrowPhase)
        {
            this.narrowPhase = narrowPhase;
            table = new AgentTable(narrowPhase.shapeChoice);
            _motions = new RowMotions(table);
            contacts = new AgentContacts(table, narrowPhase, _motions);
            _candidateTests = new CandidateTests(table, narrowPhase, _motions);
            _changedRowSearch = new ChangedRowSearch(table, _motions, _bins, _candidateTests);
            _pairs = new FoundPairs(table.listed);
            _pairsOfChanged = new FoundPairs(table.listed);
        }

        /**
         * Finds the pairs of agents that touch and whose breeds are of interest.
         *
         * @param input the agents, and which of them take part
         * @return the pairs. The next search overwrites them, and the counts of the narrow phase
         * @throws ArgumentError as CollisionSystem.findCollisions does
         * @throws RangeError as CollisionSystem.findCollisions does
         * @throws IllegalOperationError if called from a game's <code>bind()</code>, within a search
         */
        public function find(input:SearchInput):FoundPairs
        {
            if (narrowPhase.shapeChoice.isBinding)
            {
                throw new IllegalOperationError("findCollisions must not be called from bind(), while the collider searches");
            }
            var canUpdate:Boolean = hasPairsFor(input);
            // a search that throws leaves no pairs
            forgetPairs();
            readInput(input);
            // tests since the last search, as those of questions, do not count
            narrowPhase.counts.clear();
            if (canUpdate && _changedRowSearch.tryFindRows(input))
            {
                findOfChanged(input);
            }
            else
            {
                findOfAll(input);
            }
            rememberConditions(input);
            return _pairs;
        }

        /** The number of members of the last search: the agents that took part. */
        public function get memberCount():int
        {
            return _changedRowSearch.memberCount;
        }

        /** Lets the next search be one of all rows. Call it if the table was read without a search. */
        public function forgetPairs():void
        {
            _interests = null;
        }

        // Reads the input into the table. The motions are read before the places, because they begin at those of the last search.
        private function readInput(input:SearchInput):void
        {
            table.readBodies(input.agents);
            _motions.read();
            table.readPlaces();
            table.environment.read(input.ground, input.edges);
        }

        // Whether there are pairs to update: those of the last search, if it depended on the same as this one, besides agents, ground and edges.
        private function hasPairsFor(input:SearchInput):Boolean
        {
            return input.interests === _interests && input.interests.pairCount == _interestCount && narrowPhase.treeLimits.defaultDepth == _depth
                && (input.admitted != null) == _isFiltered;
        }

        private function rememberConditions(input:SearchInput):void
        {
            _interests = input.interests;
            _interestCount = input.interests.pairCount;
            _depth = narrowPhase.treeLimits.defaultDepth;
            _isFiltered = input.admitted != null;
        }

        // Finds the pairs of all members.
        private function findOfAll(input:SearchInput):void
        {
            var members:IntList = input.membersOf(table);
            _motions.findExtents(table.listed.rows);
            _candidateTests.begin(input, _pairs);
            _bins.findPairs(_motions.searchExtents, members, _candidateTests);
            _changedRowSearch.begin(members);
            // these overwrite the list of members
            _candidateTests.testWithEnvironment(ListedAgents.GROUND_ROW, table.listed.rows, input);
            _candidateTests.testWithEnvironment(ListedAgents.EDGES_ROW, table.listed.rows, input);
            _pairs.putInOrder(_motions.anySweeps);
        }

        // Finds the pairs of the changed rows, and puts them between those of the last search. The pairs and their order are the same as in a search of
        // all members. Here the row that has changed comes first, but a test gives the same answer in either order of the two.
        private function findOfChanged(input:SearchInput):void
        {
            _candidateTests.begin(input, _pairsOfChanged);
            _changedRowSearch.findPairs(input);
            _candidateTests.testWithEnvironment(ListedAgents.GROUND_ROW, _changedRowSearch.rowsToTestWith(ListedAgents.GROUND_ROW), input);
            _candidateTests.testWithEnvironment(ListedAgents.EDGES_ROW, _changedRowSearch.rowsToTestWith(ListedAgents.EDGES_ROW), input);
            var earlyCount:int = _pairsOfChanged.putInOrder(_motions.anySweeps);
            _pairs.replacePairsOf(_changedRowSearch.changedRows, _pairsOfChanged, earlyCount);
        }
    }
}
