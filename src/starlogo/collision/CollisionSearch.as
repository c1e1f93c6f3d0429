package starlogo.collision
{
    import flash.utils.getTimer;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.agents.AgentRecord;
    import starlogo.agents.CacheToken;
    import starlogo.broadphase.AgentProxy;
    import starlogo.broadphase.BinLevel;
    import starlogo.broadphase.Bins;
    import starlogo.broadphase.PairSink;
    import starlogo.engine;

    use namespace engine;

    /**
     * What all colliders do: keeps the world shapes of agents up to date, puts them into bins (thesis §3.7) and tests the pairs
     * that these find. What the shapes are is the strategy's.
     */
    internal final class CollisionSearch extends PairSink
    {
        private var _strategy:ShapeStrategy;
        private var _statistics:CollisionStatistics = new CollisionStatistics();
        private var _bins:Bins = new Bins();
        private var _shapes:ShapeCache;
        private var _frame:int = 0;

        // The search under way. The pairs of breeds that count are in a square of this width; it is null where all do.
        private var _interests:Vector.<Boolean> = null;
        private var _breedCount:int = 0;
        private var _found:Vector.<Agent> = null;
        private var _foundRecords:Vector.<AgentRecord> = null;
        private var _foundLength:int = 0;
        private var _skippedPairs:int = 0;
        private var _shapePairs:int = 0;
        private var _memberCount:int = 0;
        private var _loadingCount:int = 0;

        // How many were listed in this search, and whether somebody who was in the bins in the last may not be in this one.
        private var _listed:int = 0;
        private var _somebodyLeft:Boolean = false;

        // The pair that areColliding finds, or nothing.
        private var _asked:Vector.<Agent> = new Vector.<Agent>();

        /**
         * @param greatLand has the models of the agents
         * @param strategy says what shapes they have
         * @throws ArgumentError if greatLand is null
         */
        public function CollisionSearch(greatLand:GreatLand, strategy:ShapeStrategy)
        {
            _shapes = new ShapeCache(greatLand, strategy, _bins);
            _strategy = strategy;
        }

        /** What the last search did. */
        public function get statistics():CollisionStatistics
        {
            return _statistics;
        }

        /** Whether two agents collide, as CollisionSystem says. */
        public function areColliding(a:Agent, b:Agent):Boolean
        {
            if (a == null || b == null)
            {
                throw new ArgumentError("two agents are needed, not " + a + " and " + b);
            }
            if (a === b)
            {
                throw new ArgumentError(a + " is no pair with itself");
            }
            _shapes.noteUse();
            var shapeA:WorldShape = _shapes.shapeOf(a);
            var shapeB:WorldShape = _shapes.shapeOf(b);
            if (shapeA.level == null || shapeB.level == null)
            {
                return false;
            }
            _interests = null;
            _found = _asked;
            _foundLength = 0;
            onCandidatePair(shapeA, shapeB);
            _asked.length = 0;
            return _foundLength > 0;
        }

        /** Finds the pairs that collide and that somebody cares about, as SelectiveCollisionSystem says. */
        public function find(agents:Vector.<Agent>, interests:BreedInterests, out:Vector.<Agent>):Vector.<Agent>
        {
            if (out == null)
            {
                throw new ArgumentError("out must not be null");
            }
            search(agents, interests, out, null);
            return out;
        }

        /**
         * Does what <code>find()</code> does, but gives this search's records of the agents: who is going to look at the pairs finds
         * their places in the list and the numbers of their breeds there.
         */
        public function findRecords(agents:Vector.<Agent>, interests:BreedInterests, out:Vector.<AgentRecord>):void
        {
            search(agents, interests, null, out);
        }

        /** @inheritDoc */
        override public function onCandidatePair(a:AgentProxy, b:AgentProxy):void
        {
            if (_interests != null)
            {
                if (!_interests[int(a.breedIndex * _breedCount + b.breedIndex)])
                {
                    _skippedPairs++;
                    return;
                }
            }
            var dz:Number = a.z - b.z;
            if (a.isSphere && b.isSphere)
            {
                // the most common test by far, without a call
                var dx:Number = a.x - b.x;
                var dy:Number = a.y - b.y;
                var radii:Number = a.radius + b.radius;
                if (dx * dx + dy * dy + dz * dz > radii * radii)
                {
                    return;
                }
            }
            else
            {
                _shapePairs++;
                var reach:Number = a.halfZ + b.halfZ;
                if (dz > reach || dz < -reach)
                {
                    return;
                }
                // untyped, the cheapest of casts
                var untypedA:* = a;
                var untypedB:* = b;
                if (!_strategy.overlaps(untypedA, untypedB))
                {
                    return;
                }
            }
            var length:int = _foundLength;
            _foundLength = length + 2;
            var found:Vector.<Agent> = _found;
            if (found == null)
            {
                keepRecords(a, b, length);
            }
            else if (a.listIndex < b.listIndex)
            {
                found[length] = a.agent;
                found[int(length + 1)] = b.agent;
            }
            else
            {
                found[length] = b.agent;
                found[int(length + 1)] = a.agent;
            }
        }

        private function keepRecords(a:AgentProxy, b:AgentProxy, place:int):void
        {
            if (a.listIndex < b.listIndex)
            {
                _foundRecords[place] = a;
                _foundRecords[int(place + 1)] = b;
            }
            else
            {
                _foundRecords[place] = b;
                _foundRecords[int(place + 1)] = a;
            }
        }

        // One of the two is null.
        private function search(agents:Vector.<Agent>, interests:BreedInterests, found:Vector.<Agent>,
                foundRecords:Vector.<AgentRecord>):void
        {
            if (agents == null)
            {
                throw new ArgumentError("agents must not be null");
            }
            var start:int = getTimer();
            enterIntoBins(agents, interests);
            _strategy.resetCounts();
            _interests = interests == null ? null : interests.pairs;
            _breedCount = interests == null ? 0 : interests.breedCount;
            _found = found;
            _foundRecords = foundRecords;
            _foundLength = 0;
            _skippedPairs = 0;
            _shapePairs = 0;
            _bins.findPairs(this, _somebodyLeft);
            _found = null;
            _foundRecords = null;
            if (found != null)
            {
                found.length = _foundLength;
            }
            else
            {
                foundRecords.length = _foundLength;
            }
            report(agents.length);
            _statistics.findMs = getTimer() - start;
        }

        private function report(agentCount:int):void
        {
            _statistics.reset();
            _statistics.agents = agentCount;
            _statistics.agentsSkipped = agentCount - _memberCount - _loadingCount;
            _statistics.agentsLoading = _loadingCount;
            _statistics.binEntries = _bins.entryCount;
            _statistics.candidatePairs = _bins.pairCount - _skippedPairs;
            _statistics.sphereSphereTests = _statistics.candidatePairs - _shapePairs;
            _strategy.countInto(_statistics);
            _statistics.collisions = _foundLength >> 1;
        }

        private function enterIntoBins(agents:Vector.<Agent>, interests:BreedInterests):void
        {
            _shapes.noteUse();
            var shapes:ShapeCache = _shapes;
            var cacheToken:CacheToken = shapes.token;
            var breedToken:Object = interests == null ? null : interests.token;
            var bins:Bins = _bins;
            var lastFrame:int = _frame;
            var frame:int = ++_frame;
            var count:int = agents.length;
            var members:int = 0;
            var loading:int = 0;
            var newcomers:int = 0;
            var lookedUp:Boolean = false;
            bins.clear();
            for (var i:int = 0; i < count; i++)
            {
                var agent:Agent = agents[i];
                if (agent == null)
                {
                    throw new ArgumentError("agents[" + i + "] is null");
                }
                var record:AgentRecord = agent.records;
                if (record == null || record.cacheToken !== cacheToken)
                {
                    record = shapes.find(agent);
                }
                // untyped, the cheapest of casts
                var untyped:* = record;
                var shape:WorldShape = untyped;
                if (shape.frame != lastFrame)
                {
                    newcomers++;
                    if (shape.frame == frame)
                    {
                        throw new ArgumentError(agent + " is listed twice: agents[" + shape.listIndex + "] and agents[" + i + "]");
                    }
                }
                shape.frame = frame;
                shape.listIndex = i;
                if (shape.revision != agent.revision && !shapes.update(shape, agent))
                {
                    loading++;
                    continue;
                }
                if (breedToken != null)
                {
                    if (shape.breedToken !== breedToken)
                    {
                        interests.lookUp(shape);
                        lookedUp = true;
                    }
                    if (shape.breedIndex < 0)
                    {
                        continue;
                    }
                }
                // as Bins.add does
                var level:BinLevel = shape.level;
                level.proxies[level.count] = shape;
                level.count++;
                members++;
            }
            _somebodyLeft = lookedUp || members != _memberCount || count - newcomers != _listed;
            _listed = count;
            _memberCount = members;
            _loadingCount = loading;
        }
    }
}
