package starlogo.collision
{
    import starlogo.agents.Agent;
    import starlogo.agents.AgentRecord;
    import starlogo.agents.CacheToken;
    import starlogo.broadphase.BinLevel;
    import starlogo.broadphase.Bins;
    import starlogo.engine;
    import starlogo.geometry.Placement;

    use namespace engine;

    /**
     * The shapes of a list of agents, up to date, and in the bins. From frame to frame lists stay the same for the most part, and
     * most agents only move: what is not looked up again, and not entered again, is what makes thousands of them affordable.
     */
    internal final class ListedShapes
    {
        /** The shapes of the last list, in its order. Empty where they are not known to be the agents' own any more. */
        public var shapes:Vector.<WorldShape> = new Vector.<WorldShape>();

        /** How many of them are in the bins. */
        public var memberCount:int = 0;

        /** How many have a model that is loading. */
        public var loadingCount:int = 0;

        /** Whether somebody who was in the bins in the last search may not be in them now; who has seen to it sets it to false. */
        public var somebodyLeft:Boolean = false;

        private var _cache:ShapeCache;
        private var _bins:Bins;
        private var _frame:int = 0;

        // Of whom breeds were asked about last, or null.
        private var _breedToken:Object = null;

        // Whether those in the bins may be others than those who belong there.
        private var _membersAreStale:Boolean = true;

        /**
         * @param cache has the shapes
         * @param bins take them
         */
        public function ListedShapes(cache:ShapeCache, bins:Bins)
        {
            _cache = cache;
            _bins = bins;
        }

        /** Begins a search, or a question about two agents. */
        public function noteUse():void
        {
            if (_cache.noteUse())
            {
                shapes.length = 0;
            }
        }

        /**
         * Makes the shapes those of a list of agents, and brings them up to date.
         *
         * @param agents the list
         * @param interests says which breeds take part; null for all
         * @throws ArgumentError if an agent is null or listed twice, its model is unknown, or what is needed of it was not loaded
         */
        public function update(agents:Vector.<Agent>, interests:BreedInterests):void
        {
            enlist(agents);
            updateShapes(interests);
        }

        // Makes the shapes listed those of a list of agents: mostly they are.
        private function enlist(agents:Vector.<Agent>):void
        {
            noteUse();
            var listed:Vector.<WorldShape> = shapes;
            var same:int = 0;
            var most:int = listed.length < agents.length ? listed.length : agents.length;
            while (same < most && listed[same].agent === agents[same])
            {
                same++;
            }
            if (same < listed.length)
            {
                _membersAreStale = somebodyLeft = true;
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
            var listed:Vector.<WorldShape> = shapes;
            var frame:int = ++_frame;
            for (var i:int = 0; i < first; i++)
            {
                listed[i].frame = frame;
            }
            var cacheToken:CacheToken = _cache.token;
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
                    record = _cache.find(agent);
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
            var cache:ShapeCache = _cache;
            var listed:Vector.<WorldShape> = shapes;
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
                            cache.update(shape, agent);
                        }
                    }
                    else
                    {
                        var wasIn:Boolean = shape.level != null;
                        if (!cache.update(shape, agent))
                        {
                            loading++;
                            somebodyLeft = somebodyLeft || wasIn;
                            continue;
                        }
                    }
                }
                if (breedToken != null)
                {
                    if (shape.breedToken !== breedToken)
                    {
                        interests.lookUp(shape);
                        isStale = somebodyLeft = true;
                    }
                }
            }
            loadingCount = loading;
            _membersAreStale = isStale || cache.levelsChanged;
        }

        /** Has the bins hold those who take part: mostly they do. */
        public function fillBins():void
        {
            if (!_membersAreStale && _bins.repeat())
            {
                return;
            }
            var takesAll:Boolean = _breedToken == null;
            var listed:Vector.<WorldShape> = shapes;
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
            somebodyLeft = somebodyLeft || members < memberCount;
            memberCount = members;
            _cache.levelsChanged = _membersAreStale = false;
        }
    }
}
