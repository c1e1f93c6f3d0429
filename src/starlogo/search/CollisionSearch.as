// This room finds the pairs of agents that touch, and how they touch. AgentTable (table/) reads the agents into rows; PairFinder and
// NarrowPhase keep the pairs of the broad phase that touch, by a PairTests for each kind of pairs (pairs/); PairSorter puts them into the order of
// the list, and KeptPairs takes those of the last frame if little has changed. Read this file first, then AgentTable for the rows, NarrowPhase
// for the tests, and TreeExitSearch and GroundExitSearch (penetration/) for depths.
package starlogo.search
{
    import starlogo.agents.Agent;
    import starlogo.agents.Breeds;
    import starlogo.broadphase.Bins;
    import starlogo.broadphase.Extents;
    import starlogo.convex.ContactPoint;
    import starlogo.convex.RelativeMotion;
    import starlogo.data.IntList;
    import starlogo.engine;
    import starlogo.search.table.AgentTable;
    import starlogo.search.table.ListedAgents;

    use namespace engine;

    /**
     * Finds the pairs of agents that touch: the search that all colliders share. It reads the agents into a table. The bins find the pairs of
     * rows that are near each other (thesis §3.7). PairFinder keeps those that touch, and PairSorter puts them into order. If few agents have
     * changed, KeptPairs begins with the pairs of the last search instead.
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

        private var _bins:Bins = new Bins();
        private var _motions:RowMotions;
        private var _finder:PairFinder;

        // The pairs of the last search. KeptPairs finds them if little has changed.
        private var _pairs:FoundPairs;
        private var _keptPairs:KeptPairs;

        private var _bodyA:Body = new Body();
        private var _bodyB:Body = new Body();

        // The members of a search in which some rows may be none.
        private var _members:IntList = new IntList();

        /** @param narrowPhase may have other searches too */
        public function CollisionSearch(narrowPhase:NarrowPhase)
        {
            table = new AgentTable(narrowPhase, _bins.levels);
            _motions = new RowMotions(table);
            _finder = new PairFinder(table, _motions);
            _pairs = new FoundPairs(table.list);
            _keptPairs = new KeptPairs(table, _finder, _motions, _pairs);
        }

        /** Whether two agents touch where they are now. See CollisionSystem.areColliding. */
        public function areColliding(a:Agent, b:Agent):Boolean
        {
            var bodyA:Body = table.currentBodyOf(a, _bodyA);
            var bodyB:Body = table.currentBodyOf(b, _bodyB);
            return bodyA.shape != null && bodyB.shape != null && table.narrowPhase.areTouching(bodyA, bodyB);
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
            table.read(input.agents);
            table.readWorld(input.ground, input.edges);
            _motions.begin(input.isAnySweeping());
            // tests since the last search, as those of questions, do not count
            table.narrowPhase.takeCounts(counts);
            var memberCount:int = mayKeep && _keptPairs.find(input) ? _keptPairs.memberCount : findAll(input, mayKeep);
            table.narrowPhase.takeCounts(counts);
            counts.agents = table.list.rows.count;
            counts.agentsSkipped = table.list.rows.count - memberCount - table.loadingCount;
            counts.agentsLoading = table.loadingCount;
            counts.candidatePairs = _finder.candidatePairs;
            counts.sweptPairs = _motions.sweptPairs;
            counts.collisions = _pairs.count;
            return _pairs;
        }

        // Searches all members. Returns their number.
        private function findAll(input:FrameInput, mayKeep:Boolean):int
        {
            // also if the search throws, because the table has been read
            _keptPairs.forget();
            var members:IntList = findMembers(input);
            var extents:Extents = table.extents;
            if (_motions.areNeeded)
            {
                _motions.findMotions(table.list.rows);
                extents = _motions.extents;
            }
            _finder.begin(input, _pairs);
            _bins.findPairs(extents, members, _finder);
            _finder.findPairsOfWorldAgent(ListedAgents.GROUND_ROW, members);
            _finder.findPairsOfWorldAgent(ListedAgents.EDGES_ROW, members);
            _finder.end();
            if (mayKeep)
            {
                _keptPairs.keep(members, input);
            }
            return members.count;
        }

        /** The table was read without a search: the next search is one of all rows. */
        public function forgetSearch():void
        {
            _keptPairs.forget();
            _motions.begin(false);
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
            if (table.list.rankOf(a) <= table.list.rankOf(b))
            {
                findContactInOrder(a, b, motion, out);
                return;
            }
            findContactInOrder(b, a, motion, out);
            out.setNormal(-out.normalX, -out.normalY, -out.normalZ);
            motion.endAfter(-motion.x, -motion.y, -motion.z);
        }

        // Finds the contact of two agents in the order that the pairs of a search have, so rounding is the same however a game asks.
        private function findContactInOrder(a:Agent, b:Agent, motion:RelativeMotion, out:ContactPoint):void
        {
            var rowA:int = table.list.rowOf(a);
            var rowB:int = table.list.rowOf(b);
            var areSeen:Boolean = rowA >= 0 && rowB >= 0 && table.shapes[rowA] != null && table.shapes[rowB] != null;
            if (areSeen && _motions.areNeeded)
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
            table.narrowPhase.findContact(bodyA, bodyB, motion, out);
        }

        // The rows that the bins get, called members: those with a shape that take part and whose breeds are of interest.
        private function findMembers(input:FrameInput):IntList
        {
            var all:IntList = table.list.rows;
            if (table.loadingCount == 0 && input.admitted == null && (input.interests == null || input.interests.isNamed(Breeds.ANY)))
            {
                return all;
            }
            input.listMembers(table, all, _members);
            return _members;
        }
    }
}
