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
    import starlogo.geometry.Placement;

    use namespace engine;

    /**
     * What all colliders do: keeps the world shapes of agents up to date, puts them into bins (thesis §3.7) and tests the pairs
     * that these find. What the shapes are is the strategy's.
     */
    internal final class CollisionSearch extends PairSink
    {
        private var _greatLand:GreatLand;
        private var _strategy:ShapeStrategy;
        private var _statistics:CollisionStatistics = new CollisionStatistics();
        private var _bins:Bins = new Bins();
        private var _frame:int = 0;

        // Another one makes the shapes void: when a model was replaced.
        private var _cacheToken:CacheToken = new CacheToken();
        private var _greatLandRevision:int = 0;

        // The search under way. The pairs of breeds that count are in a square of this width; it is null where all do.
        private var _interests:Vector.<Boolean> = null;
        private var _breedCount:int = 0;
        private var _found:Vector.<Agent> = null;
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
            if (greatLand == null)
            {
                throw new ArgumentError("greatLand must not be null");
            }
            _greatLand = greatLand;
            _strategy = strategy;
            _greatLandRevision = greatLand.revision;
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
            useCache();
            var shapeA:WorldShape = shapeOf(a);
            var shapeB:WorldShape = shapeOf(b);
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
            if (agents == null || out == null)
            {
                throw new ArgumentError((agents == null ? "agents" : "out") + " must not be null");
            }
            var start:int = getTimer();
            enterIntoBins(agents, interests);
            _strategy.resetCounts();
            _interests = interests == null ? null : interests.pairs;
            _breedCount = interests == null ? 0 : interests.breedCount;
            _found = out;
            _foundLength = 0;
            _skippedPairs = 0;
            _shapePairs = 0;
            _bins.findPairs(this, _somebodyLeft);
            _found = null;
            out.length = _foundLength;
            report(agents.length);
            _statistics.findMs = getTimer() - start;
            return out;
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
                var radii:Number = a.halfX + b.halfX;
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
            var found:Vector.<Agent> = _found;
            var length:int = _foundLength;
            if (a.listIndex < b.listIndex)
            {
                found[length] = a.agent;
                found[int(length + 1)] = b.agent;
            }
            else
            {
                found[length] = b.agent;
                found[int(length + 1)] = a.agent;
            }
            _foundLength = length + 2;
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
            useCache();
            var cacheToken:CacheToken = _cacheToken;
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
                while (record != null && record.cacheToken !== cacheToken)
                {
                    record = record.next;
                }
                // untyped, the cheapest of casts
                var untyped:* = record == null ? addShape(agent) : record;
                var shape:WorldShape = untyped;
                if (shape.revision != agent.revision)
                {
                    update(shape, agent);
                }
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
                var level:BinLevel = shape.level;
                if (level == null)
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
                level.proxies[level.count] = shape;
                level.count++;
                members++;
            }
            _somebodyLeft = lookedUp || members != _memberCount || count - newcomers != _listed;
            _listed = count;
            _memberCount = members;
            _loadingCount = loading;
        }

        private function useCache():void
        {
            if (_greatLand.revision != _greatLandRevision)
            {
                _greatLandRevision = _greatLand.revision;
                _cacheToken.revoke();
                _cacheToken = new CacheToken();
            }
            _cacheToken.noteUse();
        }

        // The agent's shape, up to date; without a level while the model is loading.
        private function shapeOf(agent:Agent):WorldShape
        {
            var record:AgentRecord = agent.records;
            while (record != null && record.cacheToken !== _cacheToken)
            {
                record = record.next;
            }
            var untyped:* = record == null ? addShape(agent) : record;
            var shape:WorldShape = untyped;
            if (shape.revision != agent.revision)
            {
                update(shape, agent);
            }
            return shape;
        }

        private function addShape(agent:Agent):WorldShape
        {
            var shape:WorldShape = new WorldShape(agent, _cacheToken);
            agent.addRecord(shape);
            return shape;
        }

        private function update(shape:WorldShape, agent:Agent):void
        {
            var extentsRevision:int = agent.placement.extentsRevision;
            if (shape.extentsRevision == extentsRevision)
            {
                _strategy.updateWorldShape(shape);
                shape.revision = agent.revision;
                // as Bins.isBeyondReach says
                if (shape.x * shape.x + shape.y * shape.y >= shape.level.reachSquared)
                {
                    _bins.assignLevel(shape);
                }
            }
            else if (shape.model == agent.shape || bindModel(shape, agent))
            {
                _strategy.updateWorldShape(shape);
                shape.revision = agent.revision;
                shape.extentsRevision = extentsRevision;
                _bins.assignLevel(shape);
            }
        }

        // Whether the agent's model is there; otherwise it is loading.
        private function bindModel(shape:WorldShape, agent:Agent):Boolean
        {
            shape.unbind();
            if (!_greatLand.hasModel(agent.shape))
            {
                if (_greatLand.isLoading(agent.shape))
                {
                    return false;
                }
                throw new ArgumentError(agent + ": there is no model \"" + agent.shape + "\"; add it to the GreatLand first");
            }
            _strategy.bindModel(shape);
            shape.model = agent.shape;
            return true;
        }
    }
}
