// This room finds the pairs of agents that touch, and how they touch. AgentTable (table/) reads the agents into rows; CandidateTests keeps the pairs of
// near rows that touch, by the NarrowPhase, which has a PairTests for each kind of pairs (pairs/); FoundPairs has the pairs in the order of the list;
// and ChangedRows finds the few rows whose pairs may differ from those of the last frame. Read this file first, then AgentTable for the rows,
// CandidateTests and NarrowPhase for the tests, and ExitSearch (penetration/) for depths.
package starlogo.search
{
    import starlogo.agents.Agent;
    import starlogo.broadphase.Bins;
    import starlogo.convex.ContactPoint;
    import starlogo.convex.RelativeMotion;
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
     * <p>A question about two agents takes the bodies of their rows if the agents have not changed since, and otherwise makes bodies of them as they are
     * now. It changes no place and no motion of a search.</p>
     *
     * @private
     */
    public final class CollisionSearch
    {
        /** The agents of the last search. */
        public var table:AgentTable;

        /** Tests their bodies. It may have other searches too. */
        public var narrowPhase:NarrowPhase;

        private var _bins:Bins = new Bins();
        private var _tests:CandidateTests;
        private var _motions:RowMotions;
        private var _changedRows:ChangedRows;

        // The pairs of the search, and those of changed rows that are put between them. Whether the next search may begin with these pairs.
        private var _pairs:FoundPairs;
        private var _pairsOfChanged:FoundPairs;
        private var _mayBeKept:Boolean = false;

        // The members of a search in which some rows are no members.
        private var _members:IntList = new IntList();

        // For questions: the bodies of agents that have changed since the search.
        private var _bodyA:Body = new Body();
        private var _bodyB:Body = new Body();

        /** @param narrowPhase chooses the shapes of the agents, and tests their bodies */
        public function CollisionSearch(narrowPhase:NarrowPhase)
        {
            this.narrowPhase = narrowPhase;
            table = new AgentTable(narrowPhase.choice);
            _motions = new RowMotions(table, narrowPhase);
            _tests = new CandidateTests(table, narrowPhase, _motions);
            _changedRows = new ChangedRows(table, narrowPhase, _motions, _bins.levels);
            _pairs = new FoundPairs(table.list);
            _pairsOfChanged = new FoundPairs(table.list);
        }

        /**
         * Finds the pairs of agents that touch and whose breeds are of interest.
         *
         * @param input the agents, and which of them take part
         * @param mayKeep whether the search may begin with the pairs of the last one
         * @param counts takes the counts of this search
         * @return the pairs. The next search overwrites them
         * @throws ArgumentError as CollisionSystem.findCollisions does
         * @throws RangeError as CollisionSystem.findCollisions does
         */
        public function find(input:FrameInput, mayKeep:Boolean, counts:SearchCounts):FoundPairs
        {
            readInput(input);
            // tests since the last search, as those of questions, do not count
            narrowPhase.counts.clear();
            var mayBegin:Boolean = mayKeep && _mayBeKept;
            // if the search throws, the next one is of all rows, because the table has been read
            _mayBeKept = false;
            var isOfChanged:Boolean = mayBegin && _changedRows.moveChanged(input);
            var memberCount:int = isOfChanged ? findOfChanged(input) : findOfAll(input, mayKeep);
            counts.copyTests(narrowPhase.counts);
            counts.agents = table.list.rows.count;
            counts.agentsSkipped = table.list.rows.count - memberCount - table.loadingCount;
            counts.agentsLoading = table.loadingCount;
            counts.candidatePairs = _tests.candidatePairs;
            counts.sweptPairs = _motions.areSwept ? _motions.sweptPairs : 0;
            counts.collisions = _pairs.count;
            return _pairs;
        }

        // Reads the input into the table. The motions are noted before the table reads the places, because they begin at those of the last search.
        private function readInput(input:FrameInput):void
        {
            table.acceptList(input.agents);
            if (Agent.haveSwept)
            {
                _motions.note();
            }
            _motions.areSwept = Agent.haveSwept && isAnySweeping(input.agents);
            table.readChanges();
            table.readWorld(input.ground, input.edges);
        }

        // Finds the pairs of all members. Returns the number of members.
        private function findOfAll(input:FrameInput, mayKeep:Boolean):int
        {
            var members:IntList = input.findMembers(table, _members);
            if (_motions.areSwept)
            {
                _motions.begin(table.list.rows);
            }
            _tests.begin(input, _pairs);
            _bins.findPairs(_motions.areSwept ? _motions.extents : table.extents, members, _tests);
            for (var worldRow:int = ListedAgents.GROUND_ROW; worldRow <= ListedAgents.EDGES_ROW; worldRow++)
            {
                _tests.testWithWorldAgent(worldRow, members);
            }
            _pairs.putInOrder(_motions.areSwept);
            _mayBeKept = mayKeep && _changedRows.noteSearch(members, input);
            return members.count;
        }

        // Finds the pairs of the changed rows, and puts them between those of the last search. The pairs and their order are the same as in a search of
        // all members: a test gives the same answer in either order of the two, because the row that has changed comes first here. Returns the number of
        // members.
        private function findOfChanged(input:FrameInput):int
        {
            _tests.begin(input, _pairsOfChanged);
            _changedRows.findPairs(_tests);
            for (var worldRow:int = ListedAgents.GROUND_ROW; worldRow <= ListedAgents.EDGES_ROW; worldRow++)
            {
                _tests.testWithWorldAgent(worldRow, _changedRows.rowsToTestWith(worldRow));
            }
            var earlyCount:int = _pairsOfChanged.putInOrder(_motions.areSwept);
            _changedRows.updatePairs(_pairs, _pairsOfChanged, earlyCount);
            _mayBeKept = true;
            return _changedRows.memberCount;
        }

        // Whether an agent of the list sweeps. No entry is null.
        private static function isAnySweeping(agents:Vector.<Agent>):Boolean
        {
            var i:int = agents.length - 1;
            while (i >= 0 && !agents[i].isSweeping)
            {
                i--;
            }
            return i >= 0;
        }

        /** The table was read without a search: the next search is one of all rows. */
        public function forgetSearch():void
        {
            _mayBeKept = false;
            _motions.areSwept = false;
        }

        /** Whether two agents touch where they are now. See CollisionSystem.areColliding. */
        public function areColliding(a:Agent, b:Agent):Boolean
        {
            var bodyA:Body = table.currentBodyOf(a, _bodyA);
            var bodyB:Body = table.currentBodyOf(b, _bodyB);
            return bodyA.shape != null && bodyB.shape != null && narrowPhase.areTouching(bodyA, bodyB);
        }

        /**
         * Finds the contact of two agents that touch. It takes them where the last search saw them, or where they are now if the last search did
         * not see both. The ground and the edges of the world count as they are now, or as the last search has read them while they are held.
         *
         * @param motion receives the motion of the first relative to the second, with the time of the touch: 1 if neither sweeps
         * @param out receives the contact. Its normal points from the second agent to the first
         * @throws ArgumentError if a model is unknown or still loading, or if both stand for the ground or the edges of the world
         */
        public function findContact(a:Agent, b:Agent, motion:RelativeMotion, out:ContactPoint):void
        {
            if (a.isOfWorld && b.isOfWorld)
            {
                throw new ArgumentError("the ground and the edges of the world have no contact with each other");
            }
            var rowA:int = table.list.rowOf(a);
            var rowB:int = table.list.rowOf(b);
            if (table.list.rankOf(a, rowA) > table.list.rankOf(b, rowB))
            {
                // they get the order that the pairs of a search have, so rounding is the same however a game asks
                findContact(b, a, motion, out);
                out.setNormal(-out.normalX, -out.normalY, -out.normalZ);
                motion.endAfter(-motion.x, -motion.y, -motion.z);
                return;
            }
            var areSeen:Boolean = rowA >= 0 && rowB >= 0 && table.shapes[rowA] != null && table.shapes[rowB] != null;
            if (areSeen && _motions.areSwept)
            {
                _motions.findContact(rowA, rowB, motion, out);
                return;
            }
            var bodyA:Body = areSeen ? table.bodyOf(rowA) : table.currentBodyOf(a, _bodyA);
            var bodyB:Body = areSeen ? table.bodyOf(rowB) : table.currentBodyOf(b, _bodyB);
            if (bodyA.shape == null || bodyB.shape == null)
            {
                var loading:Agent = bodyA.shape == null ? a : b;
                throw new ArgumentError(loading + ": its model is still loading");
            }
            narrowPhase.pairTestsFor(bodyA, bodyB).findContact(bodyA, bodyB, motion, out);
        }
    }
}
