// This room finds the pairs of agents that touch, and how they touch. AgentTable (table/) reads the agents into rows; NarrowPhase tests two of them,
// by a PairTests for each kind of pairs (pairs/); FoundPairs has the pairs in the order of the list; and ChangedRows finds the few rows whose pairs
// may differ from those of the last frame. Read this file first, then AgentTable for the rows, NarrowPhase for the tests, and TreeExitSearch and
// GroundExitSearch (penetration/) for depths.
package starlogo.search
{
    import starlogo.agents.Agent;
    import starlogo.agents.Breeds;
    import starlogo.bounding.BoundingStructure;
    import starlogo.broadphase.BinLevel;
    import starlogo.broadphase.Bins;
    import starlogo.broadphase.Extents;
    import starlogo.broadphase.PairSink;
    import starlogo.convex.ContactPoint;
    import starlogo.convex.RelativeMotion;
    import starlogo.data.IntList;
    import starlogo.engine;
    import starlogo.search.pairs.PairTests;
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
    public final class CollisionSearch extends PairSink
    {
        // In place of a form: none.
        private static const NONE:int = -1;

        /** The agents of the last search. */
        public var table:AgentTable;

        private var _bins:Bins = new Bins();
        private var _rowMotions:RowMotions;
        private var _changedRows:ChangedRows;

        // The pairs of the search, and those of changed rows that are put between them. Whether the next search may begin with these pairs.
        private var _pairs:FoundPairs;
        private var _pairsOfChanged:FoundPairs;
        private var _mayBeKept:Boolean = false;

        // The motions in the search; null if no agent sweeps in it.
        private var _motions:RowMotions = null;

        // The input of the search under way, and what takes the pairs.
        private var _input:FrameInput = null;
        private var _out:FoundPairs = null;

        // The number of candidates whose breeds are of interest.
        private var _candidatePairs:int = 0;

        // If an agent sweeps: the times at which a row touches others.
        private var _times:Vector.<Number> = new Vector.<Number>();

        // The members of a search in which some rows may be none, and those that are tested with the ground or the edges of the world.
        private var _members:IntList = new IntList();
        private var _membersForWorld:IntList = new IntList();

        private var _bodyA:Body = new Body();
        private var _bodyB:Body = new Body();

        /** @param narrowPhase may have other searches too */
        public function CollisionSearch(narrowPhase:NarrowPhase)
        {
            table = new AgentTable(narrowPhase);
            _rowMotions = new RowMotions(table);
            _changedRows = new ChangedRows(table, _bins.levels);
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
            table.findChanges(input.agents);
            if (Agent.haveSwept)
            {
                _rowMotions.note();
            }
            table.readChanges();
            _motions = Agent.haveSwept && isAnySweeping(input.agents) ? _rowMotions : null;
            // tests since the last search, as those of questions, do not count
            table.narrowPhase.counts.clear();
            var mayBegin:Boolean = mayKeep && _mayBeKept;
            // if the search throws, the next one is of all rows, because the table has been read
            _mayBeKept = false;
            var isOfChanged:Boolean = mayBegin && _changedRows.find(input, _motions);
            table.readWorld(input.ground, input.edges);
            var memberCount:int = isOfChanged ? findOfChanged(input) : findOfAll(input, mayKeep);
            counts.copyTests(table.narrowPhase.counts);
            counts.agents = table.list.rows.count;
            counts.agentsSkipped = table.list.rows.count - memberCount - table.loadingCount;
            counts.agentsLoading = table.loadingCount;
            counts.candidatePairs = _candidatePairs;
            counts.sweptPairs = _motions == null ? 0 : _motions.sweptPairs;
            counts.collisions = _pairs.count;
            return _pairs;
        }

        // Finds the pairs of all members. Returns the number of members.
        private function findOfAll(input:FrameInput, mayKeep:Boolean):int
        {
            var members:IntList = findMembers(input);
            var extents:Extents = table.extents;
            if (_motions != null)
            {
                _motions.begin(table.list.rows);
                extents = _motions.extents;
            }
            begin(input, _pairs);
            _bins.findPairs(extents, members, this);
            for (var worldRow:int = ListedAgents.GROUND_ROW; worldRow <= ListedAgents.EDGES_ROW; worldRow++)
            {
                if (isOfInterest(worldRow))
                {
                    findPairsOfWorldAgent(worldRow, members);
                }
            }
            _pairs.putInOrder(_motions != null);
            _mayBeKept = mayKeep && _changedRows.noteSearch(members, input, _motions);
            return members.count;
        }

        // Finds the pairs of the changed rows, and puts them between those of the last search. The pairs and their order are the same as in a search of
        // all members: a test gives the same answer in either order of the two, because the row that has changed comes first here. Returns the number of
        // members.
        private function findOfChanged(input:FrameInput):int
        {
            begin(input, _pairsOfChanged);
            _changedRows.findPairs(this);
            for (var worldRow:int = ListedAgents.GROUND_ROW; worldRow <= ListedAgents.EDGES_ROW; worldRow++)
            {
                if (isOfInterest(worldRow))
                {
                    listMembers(_changedRows.rowsToTestWith(worldRow), input);
                    findPairsOfWorldAgent(worldRow, _members);
                }
            }
            _pairsOfChanged.putInOrder(_motions != null);
            _changedRows.updatePairs(_pairs, _pairsOfChanged);
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

        private function begin(input:FrameInput, out:FoundPairs):void
        {
            _candidatePairs = 0;
            out.begin();
            _input = input;
            _out = out;
        }

        // The rows that the bins get, called members: those with a shape that take part and whose breeds are of interest.
        private function findMembers(input:FrameInput):IntList
        {
            var all:IntList = table.list.rows;
            if (table.loadingCount == 0 && input.admitted == null && (input.interests == null || input.interests.isNamed(Breeds.ANY)))
            {
                return all;
            }
            listMembers(all, input);
            return _members;
        }

        // Lists the members among some rows.
        private function listMembers(rows:IntList, input:FrameInput):void
        {
            _members.count = 0;
            for (var i:int = 0; i < rows.count; i++)
            {
                if (isMember(rows.numbers[i], table, input))
                {
                    _members.add(rows.numbers[i]);
                }
            }
        }

        /** @inheritDoc */
        override public function onCandidates(row:int, others:Vector.<int>, count:int, level:BinLevel):void
        {
            var interests:BreedInterests = _input.interests;
            if (interests != null && !interests.includesAllOfAgents)
            {
                count = interests.keepOfInterest(table.breeds, row, others, count);
            }
            _candidatePairs += count;
            if (_motions != null)
            {
                _out.addPairs(row, others, _motions.keepTouching(level, row, others, count, _times), _times);
                return;
            }
            _out.addPairs(row, others, keepTouching(row, others, count, level), null);
        }

        // Whether there is ground, or there are edges of the world, and handlers for them.
        private function isOfInterest(worldRow:int):Boolean
        {
            return table.list.agents[worldRow] != null && _input.interests.isNamed(table.breeds[worldRow]);
        }

        // Finds the pairs of members with the ground, or with the edges of the world. It tests only members whose breeds are of
        // interest together with the breed of the ground or of the edges.
        private function findPairsOfWorldAgent(worldRow:int, members:IntList):void
        {
            _membersForWorld.copyFrom(members);
            var others:Vector.<int> = _membersForWorld.numbers;
            var count:int = _input.interests.keepOfInterest(table.breeds, worldRow, others, _membersForWorld.count);
            if (_motions != null)
            {
                _out.addPairs(worldRow, others, _motions.keepTouching(null, worldRow, others, count, _times), _times);
                return;
            }
            _out.addPairs(worldRow, others, keepTouchingWorld(worldRow, others, count), null);
        }

        // Keeps the rows that touch a row, and moves them to the beginning of the list. The level has the slack of their extents.
        private function keepTouching(row:int, others:Vector.<int>, count:int, level:BinLevel):int
        {
            // a field would be read again for each candidate
            var rows:AgentTable = table;
            var tests:NarrowPhase = rows.narrowPhase;
            if (tests.choice.areSpheres)
            {
                return tests.sphereTests.keepTouching(rows, level, row, others, count);
            }
            var body:Body = rows.bodyOf(row);
            var extents:Extents = rows.extents;
            var slack:Number = level.slack;
            // two spheres or two boxes need no test of their extents, except for the heights
            var quickForm:int = body.form == BoundingStructure.SPHERE || body.form == BoundingStructure.BOX ? body.form : NONE;
            var kept:int = 0;
            for (var i:int = 0; i < count; i++)
            {
                var other:int = others[i];
                var isNear:Boolean = rows.shapes[other].form == quickForm ? extents.areHeightsNear(row, other, slack) : extents.areNear(row, other, slack);
                if (isNear)
                {
                    var otherBody:Body = rows.bodyOf(other);
                    if (tests.pairTestsFor(body, otherBody).areTouching(body, otherBody))
                    {
                        others[kept] = other;
                        kept++;
                    }
                }
            }
            return kept;
        }

        // Keeps the rows that touch the ground or the edges of the world.
        private function keepTouchingWorld(worldRow:int, others:Vector.<int>, count:int):int
        {
            var world:Body = table.bodyOf(worldRow);
            var tests:PairTests = table.narrowPhase.pairTestsForWorldAgent(world);
            var kept:int = 0;
            for (var i:int = 0; i < count; i++)
            {
                if (tests.areTouching(table.bodyOf(others[i]), world))
                {
                    others[kept] = others[i];
                    kept++;
                }
            }
            return kept;
        }

        /** The table was read without a search: the next search is one of all rows. */
        public function forgetSearch():void
        {
            _mayBeKept = false;
            _motions = null;
        }

        /** Whether two agents touch where they are now. See CollisionSystem.areColliding. */
        public function areColliding(a:Agent, b:Agent):Boolean
        {
            var bodyA:Body = table.currentBodyOf(a, _bodyA);
            var bodyB:Body = table.currentBodyOf(b, _bodyB);
            return bodyA.shape != null && bodyB.shape != null && table.narrowPhase.areTouching(bodyA, bodyB);
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
            if (areSeen && _motions != null)
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
    }
}
