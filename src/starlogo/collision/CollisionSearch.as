package starlogo.collision
{
    import flash.utils.getTimer;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.agents.AgentRecord;
    import starlogo.bounding.Box;
    import starlogo.broadphase.AgentProxy;
    import starlogo.broadphase.Bins;
    import starlogo.broadphase.PairSink;
    import starlogo.engine;
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
        private var _listed:ListedShapes;

        // The search under way. The pairs of breeds that count; null where all do.
        private var _interests:BreedInterests = null;
        private var _boxFacesOnly:Boolean = false;
        private var _found:Vector.<Agent> = null;
        private var _foundRecords:Vector.<AgentRecord> = null;
        private var _foundLength:int = 0;
        private var _skippedPairs:int = 0;
        private var _shapePairs:int = 0;
        private var _boxPairs:int = 0;

        // Searches in which somebody sweeps, and whether the last was one.
        private var _swept:SweptSearch;
        private var _isSwept:Boolean = false;
        private var _contacts:ContactFinder;

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
            _listed = new ListedShapes(_shapes, _bins);
            _strategy = strategy;
            _swept = new SweptSearch(strategy);
            _contacts = new ContactFinder(strategy, _shapes, _swept);
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
            _listed.noteUse();
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

        /** How two agents touch that the last search saw, as ContactSystem says. */
        public function findContact(a:Agent, b:Agent, out:Contact):void
        {
            _contacts.find(_contacts.shapeOf(a), _contacts.shapeOf(b), _isSwept, out);
        }

        /** The same of records that findRecords gave. */
        public function findContactOf(a:AgentRecord, b:AgentRecord, out:Contact):void
        {
            _contacts.find(a as WorldShape, b as WorldShape, _isSwept, out);
        }

        /** @inheritDoc */
        override public function onCandidates(proxy:AgentProxy, others:Vector.<AgentProxy>, count:int):void
        {
            if (_interests != null)
            {
                var kept:int = _interests.keepThoseThatCount(proxy, others, count);
                _skippedPairs += count - kept;
                count = kept;
            }
            // untyped, the cheapest of casts
            var untyped:* = proxy;
            var shape:WorldShape = untyped;
            var isSphere:Boolean = shape.isSphere;
            var x:Number = shape.x;
            var y:Number = shape.y;
            var z:Number = shape.z;
            var reachZ:Number = shape.reachZ;
            var radius:Number = shape.radius;
            var box:Box = shape.box;
            var boxFacesOnly:Boolean = _boxFacesOnly;
            var agent:Agent = shape.agent;
            var listIndex:int = shape.listIndex;
            var found:Vector.<Agent> = _found;
            var length:int = _foundLength;
            if (box != null)
            {
                if (shape.placedRevision != shape.revision)
                {
                    shape.placeStructure();
                }
            }
            for (var i:int = 0; i < count; i++)
            {
                untyped = others[i];
                var other:WorldShape = untyped;
                var dz:Number = z - other.z;
                if (isSphere && other.isSphere)
                {
                    // without a call, like the next
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
                    _shapePairs++;
                    var reach:Number = reachZ + other.reachZ;
                    if (dz > reach || dz < -reach)
                    {
                        continue;
                    }
                    var otherBox:Box = other.box;
                    if (box != null && otherBox != null)
                    {
                        _boxPairs++;
                        if (other.placedRevision != other.revision)
                        {
                            other.placeStructure();
                        }
                        if (!boxBox(box, otherBox, boxFacesOnly))
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
                if (found == null)
                {
                    keepRecords(shape, other, length);
                }
                else if (listIndex < other.listIndex)
                {
                    found[length] = agent;
                    found[int(length + 1)] = other.agent;
                }
                else
                {
                    found[length] = other.agent;
                    found[int(length + 1)] = agent;
                }
                length += 2;
            }
            _foundLength = length;
        }

        private function keepRecords(shape:WorldShape, other:WorldShape, place:int):void
        {
            if (shape.listIndex < other.listIndex)
            {
                _foundRecords[place] = shape;
                _foundRecords[int(place + 1)] = other;
            }
            else
            {
                _foundRecords[place] = other;
                _foundRecords[int(place + 1)] = shape;
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
            // in most games nobody ever sweeps
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
            _listed.update(agents, interests);
            if (_isSwept)
            {
                _isSwept = false;
                _swept.end();
            }
            _listed.fillBins();
            _strategy.resetCounts();
            _interests = interests == null || interests.areAll ? null : interests;
            _boxFacesOnly = _strategy.boxFacesOnly;
            _found = found;
            _foundRecords = foundRecords;
            _foundLength = 0;
            _skippedPairs = 0;
            _shapePairs = 0;
            _boxPairs = 0;
            _bins.findPairs(this, _listed.somebodyLeft);
            _listed.somebodyLeft = false;
            _found = null;
            _foundRecords = null;
            report(agents.length, _listed.memberCount, _bins);
            _statistics.candidatePairs = _bins.pairCount - _skippedPairs;
            _statistics.sphereSphereTests += _statistics.candidatePairs - _shapePairs;
            _statistics.boxBoxTests += _boxPairs;
        }

        // The bins stay as they are for the next search that is none of these.
        private function searchSwept(agents:Vector.<Agent>, interests:BreedInterests, found:Vector.<Agent>,
                foundRecords:Vector.<AgentRecord>):void
        {
            if (!_isSwept)
            {
                _swept.noteShapes(_listed.shapes);
            }
            _listed.update(agents, interests);
            _strategy.resetCounts();
            _isSwept = true;
            _swept.find(_listed.shapes, interests);
            _foundLength = _swept.takePairs(found, foundRecords);
            report(agents.length, _swept.memberCount, _swept.bins);
            _swept.countInto(_statistics);
        }

        private function report(agentCount:int, members:int, bins:Bins):void
        {
            _statistics.reset();
            _statistics.agents = agentCount;
            _statistics.agentsSkipped = agentCount - members - _listed.loadingCount;
            _statistics.agentsLoading = _listed.loadingCount;
            _statistics.binEntries = bins.entryCount;
            _strategy.countInto(_statistics);
            _statistics.collisions = _foundLength >> 1;
        }
    }
}
