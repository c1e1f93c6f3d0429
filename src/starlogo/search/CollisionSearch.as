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
    import starlogo.engine;

    use namespace engine;

    /**
     * Finds the pairs of agents that touch: the search that all colliders share. It reads the agents into a table. The bins find the pairs of
     * rows that are near each other (thesis §3.7). NarrowPhase tests which of them touch. Agents that sweep are tested along their motions since
     * the last search.
     *
     * <p>A question about two agents makes bodies of them as they are now, so it does not change anything that a search keeps.</p>
     *
     * @private
     */
    public final class CollisionSearch extends PairSink
    {
        /** The agents of the last search. */
        public var table:AgentTable;

        internal var narrowPhase:NarrowPhase;
        internal var bins:Bins = new Bins();
        internal var motions:SweptPairs;

        /** Whether an agent of the last search sweeps. */
        internal var isSwept:Boolean = false;

        /** Whether all shapes that the collider has made are spheres. */
        internal var areSpheres:Boolean = false;

        /** By index in the list: whether the agent takes part; null for all. */
        internal var takePart:Vector.<Boolean> = null;

        /** Puts the pairs into the order of the list. */
        internal var order:PairOrder = new PairOrder();

        private var _shapes:ModelShapes;
        private var _held:HeldWorld = new HeldWorld();
        private var _bodyA:Body = new Body();
        private var _bodyB:Body = new Body();

        // The rows that the bins get, called members: all rows, or only rows that take part and whose breeds are of interest. Their number. The
        // members that touch the ground or the edges.
        private var _memberRows:Vector.<int>;
        private var _memberCount:int = 0;
        private var _someRows:Vector.<int> = new Vector.<int>();
        private var _atFixture:Vector.<int> = new Vector.<int>();

        // Finds the pairs of a search in which little has changed.
        private var _kept:KeptPairs;

        // The search under way. _interests is null if all pairs count. Found pairs go to _out.
        private var _interests:BreedInterests;
        private var _out:FoundPairs;
        private var _candidatePairs:int;

        /**
         * @param choice finds the shapes of agents
         * @param narrowPhase tests which of them touch
         */
        public function CollisionSearch(choice:AgentShapes, narrowPhase:NarrowPhase)
        {
            this.narrowPhase = narrowPhase;
            _shapes = new ModelShapes(choice);
            table = new AgentTable(_shapes, bins.levels);
            motions = new SweptPairs(narrowPhase);
            _kept = new KeptPairs(this);
        }

        /** Whether two agents touch where they are now. See CollisionSystem.areColliding. */
        public function areColliding(a:Agent, b:Agent):Boolean
        {
            var bodyA:Body = table.bodyOfNow(a, _bodyA);
            var bodyB:Body = table.bodyOfNow(b, _bodyB);
            return bodyA.shape != null && bodyB.shape != null && narrowPhase.areTouching(bodyA, bodyB);
        }

        /**
         * Finds the pairs of agents that touch and whose breeds are of interest.
         *
         * @param agents the list
         * @param interests the pairs of breeds; null for all
         * @param takePart by index in the list: whether the agent takes part; null for all
         * @param out takes the pairs
         * @param counts takes the counts of this search
         * @param mayKeep whether the search may begin with the pairs of the last one, which are in out then
         * @param fixtures the agent of the ground, or null, and the agent of the edges of the world, or null. Null if there are none
         * @throws ArgumentError as CollisionSystem.findCollisions does
         */
        public function find(agents:Vector.<Agent>, interests:BreedInterests, takePart:Vector.<Boolean>, out:FoundPairs, counts:SearchCounts,
                mayKeep:Boolean, fixtures:Vector.<Agent>):void
        {
            table.read(agents);
            for (var row:int = ListedAgents.GROUND; row <= ListedAgents.EDGES; row++)
            {
                table.readWorldAgent(row, fixtures == null ? null : fixtures[row]);
            }
            areSpheres = _shapes.areSpheres;
            isSwept = Agent.haveSwept && SweptPairs.anySweeping(agents);
            this.takePart = takePart;
            _interests = interests;
            _candidatePairs = 0;
            // tests since the last search, as those of questions, do not count
            narrowPhase.takeCounts(counts);
            if (!mayKeep)
            {
                _kept.forget();
            }
            var isLikeLast:Boolean = mayKeep && _kept.begin(interests);
            if (isLikeLast && _kept.find(out))
            {
                _memberCount = _kept.memberCount;
            }
            else
            {
                findAll(out);
                if (isLikeLast)
                {
                    _kept.keep(out, _memberRows, _memberCount);
                }
            }
            _out = null;
            report(agents.length, out.count, counts);
        }

        private function findAll(out:FoundPairs):void
        {
            if (isSwept)
            {
                motions.find(table, bins.levels, table.list.rows, table.list.count);
            }
            chooseMembers();
            writeTo(out);
            bins.findPairs(extents, _memberRows, _memberCount, this);
            for (var row:int = ListedAgents.GROUND; row <= ListedAgents.EDGES; row++)
            {
                findAtFixture(row, _memberRows, _memberCount);
            }
            order.sort(out, isSwept);
        }

        /** The extents of the search: those of whole motions if an agent sweeps. */
        internal function get extents():Extents
        {
            return isSwept ? motions.extents : table.extents;
        }

        /** Says where the pairs go. */
        internal function writeTo(out:FoundPairs):void
        {
            out.begin(table.list);
            _out = out;
        }

        /** The speed at which the two agents of the last findContact came together, in patches a frame. */
        public function get approachSpeed():Number
        {
            return motions.approachSpeed;
        }

        /** The table was read without a search: the next search is one of all rows. */
        public function forgetSearch():void
        {
            _kept.forget();
            isSwept = false;
        }

        /**
         * Finds the contact of two agents that touch. It takes them where the last search saw them, or where they are now if the last search did
         * not see both. The ground and the edges of the world count as they are now, or as they were when they were held.
         *
         * @param out receives the contact. Its normal points from b to a
         * @return the time of the contact in their motions, from 0 to 1
         * @throws ArgumentError if a model is unknown or still loading, or if both stand for the ground or the edges of the world
         */
        public function findContact(a:Agent, b:Agent, out:ContactPoint):Number
        {
            if (Breeds.isReserved(a.breedNumber) && Breeds.isReserved(b.breedNumber))
            {
                throw new ArgumentError("the ground and the edges of the world have no contact with each other");
            }
            if (comesAfter(a, b))
            {
                // as in the pairs of a search, so rounding is the same in either order
                var time:Number = findContact(b, a, out);
                out.setNormal(-out.normalX, -out.normalY, -out.normalZ);
                return time;
            }
            var rowA:int = table.list.rowOf(a);
            var rowB:int = table.list.rowOf(b);
            if (rowA >= 0 && rowB >= 0 && table.shapes[rowA] != null && table.shapes[rowB] != null)
            {
                return motions.findContact(table, rowA, rowB, isSwept, out);
            }
            var bodyA:Body = table.bodyOfNow(a, _bodyA);
            var bodyB:Body = table.bodyOfNow(b, _bodyB);
            if (bodyA.shape == null || bodyB.shape == null)
            {
                var loading:Agent = bodyA.shape == null ? a : b;
                throw new ArgumentError(loading + ": its model is still loading");
            }
            return motions.findStaticContact(bodyA, bodyB, out);
        }

        // Whether the second of two agents comes first in a pair. The ground and the edges of the world come last.
        private function comesAfter(a:Agent, b:Agent):Boolean
        {
            if (Breeds.isReserved(a.breedNumber) || Breeds.isReserved(b.breedNumber))
            {
                return Breeds.isReserved(a.breedNumber);
            }
            var rowA:int = table.list.rowOf(a);
            var rowB:int = table.list.rowOf(b);
            if (rowA >= 0 && rowB >= 0)
            {
                return table.list.ranks[rowA] > table.list.ranks[rowB];
            }
            return rowB >= 0 || rowA < 0 && a.number > b.number;
        }

        /** Keeps the ground and the edges of the world of the last search as they are now, for findContact. */
        public function holdWorld():void
        {
            _held.hold(table, narrowPhase);
        }

        /** From now on the ground and the edges count as they are. */
        public function releaseWorld():void
        {
            _held.release(table);
        }

        /** @inheritDoc */
        override public function onCandidates(row:int, others:Vector.<int>, count:int, level:BinLevel):void
        {
            if (_interests != null && !_interests.areAll)
            {
                count = _interests.keepOfInterest(table.breeds, row, others, count);
            }
            _candidatePairs += count;
            if (isSwept)
            {
                count = keepTouchingMotions(row, others, count, level);
            }
            else if (areSpheres)
            {
                narrowPhase.spheres.writeTouching(table, level.slack, row, others, count, _out);
                return;
            }
            else
            {
                count = narrowPhase.keepTouching(table, level.slack, row, others, count);
            }
            _out.addPairs(row, others, count);
        }

        /**
         * Finds the pairs of rows with the ground, or with the edges of the world, if these take part. It tests only members whose breeds are of
         * interest together with the fixture's breed.
         *
         * @param fixture the row of the ground or of the edges
         * @param candidates the rows
         * @param length the number of rows
         */
        internal function findAtFixture(fixture:int, candidates:Vector.<int>, length:int):void
        {
            if (table.list.agents[fixture] == null || !_interests.isEntered(fixture))
            {
                return;
            }
            var others:Vector.<int> = _atFixture;
            var count:int = 0;
            for (var i:int = 0; i < length; i++)
            {
                if (isMember(candidates[i]))
                {
                    others[count] = candidates[i];
                    count++;
                }
            }
            count = _interests.keepOfInterest(table.breeds, fixture, others, count);
            if (isSwept)
            {
                count = keepTouchingMotions(fixture, others, count, null);
            }
            else
            {
                var body:Body = table.bodyOf(fixture);
                count = narrowPhase.testsOf(body, body).keepRows(table, others, count, body);
            }
            _out.addPairs(fixture, others, count);
        }

        // In most searches all agents take part, and the table's own list of rows is used.
        private function chooseMembers():void
        {
            _memberRows = table.list.rows;
            _memberCount = table.list.count;
            var outsiders:int = _interests == null ? 0 : _interests.countOutsiders(table);
            if (table.loadingCount == 0 && takePart == null && outsiders == 0)
            {
                return;
            }
            _memberRows = _someRows;
            _memberCount = 0;
            for (var i:int = 0; i < table.list.count; i++)
            {
                if (isMember(table.list.rows[i]))
                {
                    _someRows[_memberCount] = table.list.rows[i];
                    _memberCount++;
                }
            }
        }

        /** Whether the agent of a row takes part in the search. */
        internal function isMember(row:int):Boolean
        {
            return table.shapes[row] != null && (_interests == null || _interests.indexOfNumber(table.breeds[row]) >= 0) && (takePart == null || takePart[table.list.ranks[row]]);
        }

        // Like keepTouching, and writes the times. There is no level for the ground and the edges, whose extents say nothing.
        private function keepTouchingMotions(row:int, others:Vector.<int>, count:int, level:BinLevel):int
        {
            var at:int = _out.count;
            var ranks:Vector.<int> = table.list.ranks;
            var rank:int = ranks[row];
            var kept:int = 0;
            for (var i:int = 0; i < count; i++)
            {
                var other:int = others[i];
                // the time belongs to the motion of the agent that comes first in the list, relative to the other
                var isFirst:Boolean = rank < ranks[other];
                motions.findTime(table, level, isFirst ? row : other, isFirst ? other : row, null);
                var time:Number = motions.foundTime;
                if (time != RelativeMotion.NEVER)
                {
                    others[kept] = other;
                    _out.times[int(at + kept)] = time;
                    kept++;
                }
            }
            return kept;
        }

        private function report(agentCount:int, pairCount:int, counts:SearchCounts):void
        {
            narrowPhase.takeCounts(counts);
            counts.agents = agentCount;
            counts.agentsSkipped = agentCount - _memberCount - table.loadingCount;
            counts.agentsLoading = table.loadingCount;
            counts.candidatePairs = _candidatePairs;
            counts.collisions = pairCount;
        }
    }
}
