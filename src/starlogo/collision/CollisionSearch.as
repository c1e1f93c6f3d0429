package starlogo.collision
{
    import flash.utils.getTimer;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.agents.AgentRecord;
    import starlogo.agents.CacheToken;
    import starlogo.bounding.Box;
    import starlogo.broadphase.AgentProxy;
    import starlogo.broadphase.BinLevel;
    import starlogo.broadphase.Bins;
    import starlogo.broadphase.PairSink;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.intersection.boxBox;

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

        // The shapes of the last search, in the order of its list: mostly this one's is the same. Empty where they are not known
        // to be the agents' own any more.
        private var _listed:Vector.<WorldShape> = new Vector.<WorldShape>();

        // Whether those in the bins may be others than those who belong there; and whether somebody who is in them left.
        private var _membersAreStale:Boolean = true;
        private var _somebodyLeft:Boolean = false;

        // The search under way. The pairs of breeds that count are in a square of this width; it is null where all do.
        private var _interests:Vector.<Boolean> = null;
        private var _breedCount:int = 0;
        private var _breedToken:Object = null;
        private var _boxFacesOnly:Boolean = false;
        private var _found:Vector.<Agent> = null;
        private var _foundRecords:Vector.<AgentRecord> = null;
        private var _foundLength:int = 0;
        private var _skippedPairs:int = 0;
        private var _spherePairs:int = 0;
        private var _boxPairs:int = 0;
        private var _memberCount:int = 0;
        private var _loadingCount:int = 0;

        // Searches in which somebody sweeps, and whether the last was one.
        private var _swept:SweptSearch;
        private var _isSwept:Boolean = false;

        // The pair that areColliding asks about, and who it finds, if so.
        private var _asked:Vector.<AgentProxy> = new Vector.<AgentProxy>();
        private var _answer:Vector.<Agent> = new Vector.<Agent>();

        /**
         * @param greatLand has the models of the agents
         * @param strategy says what shapes they have
         * @throws ArgumentError if greatLand is null
         */
        public function CollisionSearch(greatLand:GreatLand, strategy:ShapeStrategy)
        {
            _shapes = new ShapeCache(greatLand, strategy, _bins);
            _strategy = strategy;
            _swept = new SweptSearch(strategy);
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
            if (_shapes.noteUse())
            {
                _listed.length = 0;
            }
            var shapeA:WorldShape = _shapes.shapeOf(a);
            var shapeB:WorldShape = _shapes.shapeOf(b);
            if (shapeA.level == null || shapeB.level == null)
            {
                return false;
            }
            _interests = null;
            _found = _answer;
            _foundLength = 0;
            _boxFacesOnly = _strategy.boxFacesOnly;
            _asked[0] = shapeB;
            onCandidates(shapeA, _asked, 1);
            _asked.length = 0;
            _answer.length = 0;
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

        /** How two agents touch that the last search saw, as Collider says. */
        public function findContact(a:Agent, b:Agent, out:Contact):void
        {
            findContactOf(seenShapeOf(a), seenShapeOf(b), out);
        }

        /** The same of records that findRecords gave. */
        public function findContactOf(a:AgentRecord, b:AgentRecord, out:Contact):void
        {
            _swept.findContact(a as WorldShape, b as WorldShape, _isSwept, out);
        }

        // As the last search has left it; now, if none has seen it.
        private function seenShapeOf(agent:Agent):WorldShape
        {
            var shape:WorldShape = _shapes.find(agent);
            if (shape.level == null)
            {
                shape = _shapes.shapeOf(agent);
                if (shape.level == null)
                {
                    throw new ArgumentError(agent + ": its model is still loading");
                }
            }
            return shape;
        }

        /** @inheritDoc */
        override public function onCandidates(proxy:AgentProxy, others:Vector.<AgentProxy>, count:int):void
        {
            var interests:Vector.<Boolean> = _interests;
            var row:int = proxy.breedIndex * _breedCount;
            // untyped, the cheapest of casts
            var untyped:* = proxy;
            var shape:WorldShape = untyped;
            var isSphere:Boolean = shape.isSphere;
            var x:Number = shape.x;
            var y:Number = shape.y;
            var z:Number = shape.z;
            var radius:Number = shape.radius;
            var box:Box = shape.box;
            var agent:Agent = shape.agent;
            var listIndex:int = shape.listIndex;
            var found:Vector.<Agent> = _found;
            var foundRecords:Vector.<AgentRecord> = _foundRecords;
            var length:int = _foundLength;
            for (var i:int = 0; i < count; i++)
            {
                untyped = others[i];
                var other:WorldShape = untyped;
                if (interests != null)
                {
                    if (!interests[int(row + other.breedIndex)])
                    {
                        _skippedPairs++;
                        continue;
                    }
                }
                var dz:Number = z - other.z;
                if (isSphere && other.isSphere)
                {
                    // without a call, like the next
                    _spherePairs++;
                    var dx:Number = x - other.x;
                    var dy:Number = y - other.y;
                    var radii:Number = radius + other.radius;
                    if (dx * dx + dy * dy + dz * dz > radii * radii)
                    {
                        continue;
                    }
                }
                else
                {
                    var reach:Number = shape.reachZ + other.reachZ;
                    if (dz > reach || dz < -reach)
                    {
                        continue;
                    }
                    var otherBox:Box = other.box;
                    if (box != null && otherBox != null)
                    {
                        _boxPairs++;
                        if (shape.placedRevision != shape.revision)
                        {
                            shape.placeStructure();
                        }
                        if (other.placedRevision != other.revision)
                        {
                            other.placeStructure();
                        }
                        if (!boxBox(box, otherBox, _boxFacesOnly))
                        {
                            continue;
                        }
                    }
                    else if (!_strategy.overlaps(shape, other))
                    {
                        continue;
                    }
                }
                // as the list has them
                var isLater:Boolean = listIndex > other.listIndex;
                if (found == null)
                {
                    foundRecords[length] = isLater ? other : shape;
                    foundRecords[int(length + 1)] = isLater ? shape : other;
                }
                else if (isLater)
                {
                    found[length] = other.agent;
                    found[int(length + 1)] = agent;
                }
                else
                {
                    found[length] = agent;
                    found[int(length + 1)] = other.agent;
                }
                length += 2;
            }
            _foundLength = length;
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
            // nobody has ever swept in most games
            if (Agent.haveSwept && SweptSearch.isNeeded(agents))
            {
                searchSwept(agents, interests, found, foundRecords);
            }
            else
            {
                searchStanding(agents, interests, found, foundRecords);
            }
            if (found != null)
            {
                found.length = _foundLength;
            }
            else
            {
                foundRecords.length = _foundLength;
            }
            _statistics.findMs = getTimer() - start;
        }

        private function searchStanding(agents:Vector.<Agent>, interests:BreedInterests, found:Vector.<Agent>,
                foundRecords:Vector.<AgentRecord>):void
        {
            _isSwept = false;
            enlist(agents);
            updateShapes(interests);
            if (_membersAreStale || !_bins.repeat())
            {
                fillBins();
            }
            _strategy.resetCounts();
            _interests = interests == null ? null : interests.pairs;
            _breedCount = interests == null ? 0 : interests.breedCount;
            _boxFacesOnly = _strategy.boxFacesOnly;
            _found = found;
            _foundRecords = foundRecords;
            _foundLength = 0;
            _skippedPairs = 0;
            _spherePairs = 0;
            _boxPairs = 0;
            _bins.findPairs(this, _somebodyLeft);
            _somebodyLeft = false;
            _found = null;
            _foundRecords = null;
            report(agents.length, _memberCount, _bins);
        }

        // Leaves the bins as they are for the next search that is none of these.
        private function searchSwept(agents:Vector.<Agent>, interests:BreedInterests, found:Vector.<Agent>,
                foundRecords:Vector.<AgentRecord>):void
        {
            if (!_isSwept)
            {
                _swept.noteShapes(_listed);
            }
            _isSwept = false;
            enlist(agents);
            updateShapes(interests);
            _strategy.resetCounts();
            _swept.find(_listed, interests);
            _isSwept = true;
            var pairs:Vector.<WorldShape> = _swept.pairs;
            _foundLength = _swept.length;
            for (var i:int = 0; i < _foundLength; i++)
            {
                if (found != null)
                {
                    found[i] = pairs[i].agent;
                }
                else
                {
                    foundRecords[i] = pairs[i];
                }
            }
            _skippedPairs = _swept.skippedPairs;
            _spherePairs = _swept.spherePairs;
            _boxPairs = 0;
            report(agents.length, _swept.memberCount, _swept.bins);
            _statistics.sweptPairs = _swept.sweptPairs;
        }

        private function report(agentCount:int, members:int, bins:Bins):void
        {
            _statistics.reset();
            _statistics.agents = agentCount;
            _statistics.agentsSkipped = agentCount - members - _loadingCount;
            _statistics.agentsLoading = _loadingCount;
            _statistics.binEntries = bins.entryCount;
            _statistics.candidatePairs = bins.pairCount - _skippedPairs;
            _statistics.sphereSphereTests = _spherePairs;
            _statistics.boxBoxTests = _boxPairs;
            _strategy.countInto(_statistics);
            _statistics.collisions = _foundLength >> 1;
        }

        // Makes the shapes listed those of a list of agents: mostly they are.
        private function enlist(agents:Vector.<Agent>):void
        {
            if (_shapes.noteUse())
            {
                _listed.length = 0;
            }
            var listed:Vector.<WorldShape> = _listed;
            var same:int = 0;
            var most:int = listed.length < agents.length ? listed.length : agents.length;
            while (same < most && listed[same].agent === agents[same])
            {
                same++;
            }
            if (same < listed.length)
            {
                _membersAreStale = _somebodyLeft = true;
                listed.length = same;
            }
            if (same < agents.length)
            {
                _membersAreStale = true;
                enlistFrom(same, agents);
            }
        }

        // From there on, one by one; nobody may come twice.
        private function enlistFrom(first:int, agents:Vector.<Agent>):void
        {
            var listed:Vector.<WorldShape> = _listed;
            var frame:int = ++_frame;
            for (var i:int = 0; i < first; i++)
            {
                listed[i].frame = frame;
            }
            var cacheToken:CacheToken = _shapes.token;
            for (i = first; i < agents.length; i++)
            {
                var agent:Agent = agents[i];
                if (agent == null)
                {
                    throw new ArgumentError("agents[" + i + "] is null");
                }
                var record:AgentRecord = agent.records;
                if (record == null || record.cacheToken !== cacheToken)
                {
                    record = _shapes.find(agent);
                }
                // untyped, the cheapest of casts
                var untyped:* = record;
                var shape:WorldShape = untyped;
                if (shape.frame == frame)
                {
                    throw new ArgumentError(agent + " is listed twice: agents[" + shape.listIndex + "] and agents[" + i + "]");
                }
                shape.frame = frame;
                shape.listIndex = i;
                listed[i] = shape;
            }
        }

        // Brings the listed shapes up to date, and notes whether those who belong into the bins are still the same.
        private function updateShapes(interests:BreedInterests):void
        {
            var breedToken:Object = interests == null ? null : interests.token;
            var isStale:Boolean = _membersAreStale || breedToken !== _breedToken;
            _breedToken = breedToken;
            // in case that one can't be brought up to date
            _membersAreStale = true;
            var shapes:ShapeCache = _shapes;
            var listed:Vector.<WorldShape> = _listed;
            var count:int = listed.length;
            var loading:int = 0;
            for (var i:int = 0; i < count; i++)
            {
                var shape:WorldShape = listed[i];
                var agent:Agent = shape.agent;
                if (shape.revision != agent.revision)
                {
                    var placement:Placement = shape.placement;
                    if (shape.extentsRevision == placement.extentsRevision)
                    {
                        // as ShapeCache.update does
                        var x:Number = placement.x + shape.offsetX;
                        var y:Number = placement.y + shape.offsetY;
                        var z:Number = placement.z + shape.offsetZ;
                        shape.x = x;
                        shape.y = y;
                        shape.z = z;
                        var reach:Number = shape.reachX;
                        shape.minX = x - reach;
                        shape.maxX = x + reach;
                        reach = shape.reachY;
                        shape.minY = y - reach;
                        shape.maxY = y + reach;
                        shape.revision = agent.revision;
                        if (x * x + y * y + z * z >= shape.level.reachSquared)
                        {
                            shapes.update(shape, agent);
                        }
                    }
                    else
                    {
                        var wasIn:Boolean = shape.level != null;
                        if (!shapes.update(shape, agent))
                        {
                            loading++;
                            _somebodyLeft = _somebodyLeft || wasIn;
                            continue;
                        }
                    }
                }
                if (breedToken != null)
                {
                    if (shape.breedToken !== breedToken)
                    {
                        interests.lookUp(shape);
                        isStale = _somebodyLeft = true;
                    }
                }
            }
            _loadingCount = loading;
            _membersAreStale = isStale || shapes.levelsChanged;
        }

        private function fillBins():void
        {
            var takesAll:Boolean = _breedToken == null;
            var listed:Vector.<WorldShape> = _listed;
            var count:int = listed.length;
            var members:int = 0;
            _bins.clear();
            for (var i:int = 0; i < count; i++)
            {
                var shape:WorldShape = listed[i];
                var level:BinLevel = shape.level;
                if (level != null)
                {
                    if (takesAll || shape.breedIndex >= 0)
                    {
                        // as Bins.add does
                        level.proxies[level.count] = shape;
                        level.count++;
                        members++;
                    }
                }
            }
            _somebodyLeft = _somebodyLeft || members < _memberCount;
            _memberCount = members;
            _shapes.levelsChanged = _membersAreStale = false;
        }
    }
}
